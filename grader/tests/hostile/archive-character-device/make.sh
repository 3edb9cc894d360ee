# An entry of a tar, which takes no root: name, kind 3 (a character device), major and minor number.
perl -e '
    my $entry = pack("a100 a8 a8 a8 a12 a12 A8 a1 a100 a6 a2 a32 a32 a8 a8 a155 x12",
                     "06-rotation/rotation.cpp", "0000644", "0000000", "0000000", "00000000000",
                     "00000000000", "", "3", "", "ustar", "00", "root", "root", "0000001",
                     "0000005", "");
    substr($entry, 148, 8) = sprintf("%06o\0 ", unpack("%32C*", $entry));
    print $entry, "\0" x 1024' > archive.tar
