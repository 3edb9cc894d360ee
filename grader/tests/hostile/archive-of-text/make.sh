echo "my homework" > archive.zip
