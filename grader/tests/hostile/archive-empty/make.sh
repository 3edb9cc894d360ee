mkdir nothing
tar -cf archive.tar nothing
