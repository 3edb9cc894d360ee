setpriority(PRIO_PROCESS, 0, -20);
sched_param most{99};
sched_setscheduler(0, SCHED_FIFO, &most);
return glm::mat3(1.0f);
