> archive.zip
