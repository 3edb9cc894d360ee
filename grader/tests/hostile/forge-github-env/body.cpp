const char* file = std::getenv("GITHUB_ENV");
const std::string lines = "\nBASH_ENV=/tmp/forged\n::set-env name=BASH_ENV::/tmp/forged\n::add-path::/tmp\n";
for (const std::string name : {file ? file : "/nowhere", "@GITHUB_ENV@"})
    std::ofstream(name, std::ios::app) << lines;
std::cout << lines << std::flush;
throw std::runtime_error((file ? "there is a variable" : "there is no variable") + lines);
