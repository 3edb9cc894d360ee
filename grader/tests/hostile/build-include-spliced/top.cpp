#inc\
lude \
"@SECRET@"
