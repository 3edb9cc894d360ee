cd 09-scene-graph
for file in Scene.cpp Table.cpp; do
    echo '#include "/dev/zero"' > $file
done
