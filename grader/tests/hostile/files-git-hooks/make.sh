mkdir -p .git/hooks
printf '#!/bin/sh\ntouch @SECRET@.hook\n' | tee .git/hooks/post-checkout > .git/hooks/pre-commit
chmod +x .git/hooks/*
printf '[core]\n\tfsmonitor = touch @SECRET@.hook\n' > .git/config
