# A second entry of a tar, which takes no root: name, kind 4 (a block device), its numbers.
tar -cf whole.tar 06-rotation
perl -e '
    my $entry = pack("a100 a8 a8 a8 a12 a12 A8 a1 a100 a6 a2 a32 a32 a8 a8 a155 x12",
                     "06-rotation/disk", "0000644", "0000000", "0000000", "00000000000",
                     "00000000000", "", "4", "", "ustar", "00", "root", "root", "0000010",
                     "0000000", "");
    substr($entry, 148, 8) = sprintf("%06o\0 ", unpack("%32C*", $entry));
    print $entry' > archive.tar
cat whole.tar >> archive.tar
rm whole.tar
