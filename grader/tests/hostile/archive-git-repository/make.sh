mkdir -p 06-rotation/.git/hooks
printf "#!/bin/sh\ntouch /tmp/left-behind\n" > 06-rotation/.git/hooks/post-checkout
chmod +x 06-rotation/.git/hooks/post-checkout
printf "[core]\nfsmonitor = touch /tmp/left-behind\n" > 06-rotation/.git/config
tar -czf archive.tar.gz 06-rotation
