mkdir -p 06-rotation/tests grader
echo "int main() {}" > 06-rotation/tests/Rotation_test.cpp
echo "{}" > 06-rotation/assignment.json
echo x > grader/main.cpp
tar -czf archive.tar.gz 06-rotation grader
