#include "io/jobs/job_record.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/base/build.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "io/base/files.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr int formatVersion = 1;
constexpr std::size_t idDigits = 12;

fs::path recordPath(const std::string& store, const std::string& id) {
    return fs::path(jobsFolder(store)) / id / "record.json";
}

json taskJson(const JobTask& task) {
    return {{"key", task.key},         {"name", task.name},           {"bodies", task.bodies},
            {"command", task.command}, {"slurm", task.slurm},         {"attempts", task.attempts},
            {"minutes", task.minutes}, {"mebibytes", task.mebibytes}, {"failure", task.failure}};
}

JobTask taskFrom(const JsonCursor& cursor) {
    JobTask task;
    task.key = cursor["key"].text();
    task.name = cursor["name"].text();
    task.bodies = cursor["bodies"].integer();
    task.command = cursor["command"].text();
    task.slurm = cursor["slurm"].text();
    task.attempts = static_cast<int>(cursor["attempts"].integer());
    task.minutes = cursor["minutes"].integer();
    task.mebibytes = cursor["mebibytes"].integer();
    task.failure = cursor["failure"].text();
    return task;
}

}  // namespace

std::string jobId(const std::vector<JobTask>& tasks) {
    std::vector<std::string> keys;
    for (const JobTask& task : tasks) {
        keys.push_back(task.key);
    }
    std::sort(keys.begin(), keys.end());
    Hasher hasher;
    for (const std::string& key : keys) {
        hasher.text(key);
    }
    return hasher.finish().hex().substr(0, idDigits);
}

std::string jobsFolder(const std::string& store) {
    return (fs::path(store) / "jobs").string();
}

void keepJob(const std::string& store, const JobRecord& record) {
    const fs::path path = recordPath(store, record.id);
    std::error_code failed;
    fs::create_directories(path.parent_path(), failed);
    if (failed) {
        throw WorldError({"io.cache.folder", "The folder {0} cannot be made: {1}", {path.parent_path().string(), failed.message()}},
                         {"io.cache.folder.remedy", "Name another folder, or check its rights.", {}});
    }
    json object{
        {"version", formatVersion},       {"id", record.id},           {"study", record.study}, {"subject", record.subject},
        {"build", record.build},          {"islands", record.islands}, {"cpus", record.cpus},   {"submitted", record.submitted},
        {"sbatch", record.sbatchOptions}, {"request", record.request}};
    object["tasks"] = json::array();
    for (const JobTask& task : record.tasks) {
        object["tasks"].push_back(taskJson(task));
    }
    writeAtomically(path.string(),
                    [&](std::ostream& out) { out << object.dump(2, ' ', false, json::error_handler_t::replace) << '\n'; });
}

JobRecord loadJob(const std::string& store, const std::string& id) {
    const std::string path = recordPath(store, id).string();
    std::ifstream stream(path, std::ios::binary);
    if (!stream || id.find('/') != std::string::npos) {
        throw WorldError({"io.no_job", "There is no job {0} in {1}.", {id, jobsFolder(store)}},
                         {"io.no_job.remedy", "See which there are: rubble-cli jobs list.", {}});
    }
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const json document = parseJson(text, path);
    const JsonCursor cursor(document, path);
    if (cursor["version"].integer() != formatVersion) {
        cursor["version"].fail("version 1");
    }
    JobRecord record;
    record.id = cursor["id"].text();
    record.study = cursor["study"].text();
    record.subject = cursor["subject"].text();
    record.build = cursor["build"].text();
    record.submitted = cursor["submitted"].text();
    record.islands = cursor["islands"].flag();
    record.cpus = static_cast<int>(cursor["cpus"].integer());
    for (const JsonCursor& option : cursor["sbatch"].elements()) {
        record.sbatchOptions.push_back(option.text());
    }
    // Older ones do not say it.
    if (cursor.has("request")) {
        for (const JsonCursor& word : cursor["request"].elements()) {
            record.request.push_back(word.text());
        }
    }
    for (const JsonCursor& task : cursor["tasks"].elements()) {
        record.tasks.push_back(taskFrom(task));
    }
    return record;
}

std::vector<std::string> jobIds(const std::string& store) {
    std::vector<std::pair<fs::file_time_type, std::string>> found;
    std::error_code ignored;
    for (fs::directory_iterator it(jobsFolder(store), ignored), end; it != end; it.increment(ignored)) {
        const fs::file_time_type time = fs::last_write_time(it->path() / "record.json", ignored);
        if (!ignored) {
            found.emplace_back(time, it->path().filename().string());
        }
    }
    std::sort(found.rbegin(), found.rend());
    std::vector<std::string> ids;
    for (auto& [time, id] : found) {
        ids.push_back(std::move(id));
    }
    return ids;
}

std::optional<JobRecord> newestJob(const std::string& store, const std::string& study,
                                   const std::function<bool(const JobRecord&)>& wanted) {
    for (const std::string& id : jobIds(store)) {
        try {
            JobRecord record = loadJob(store, id);
            if (record.study == study && record.build == buildText() && wanted(record)) {
                return record;
            }
        } catch (const ParseError&) {
            // Nothing can be learned from it.
        } catch (const WorldError&) {
            // Somebody has just cleared it.
        }
    }
    return {};
}

bool isMade(const std::string& store, const JobRecord& record, const JobTask& task) {
    std::error_code ignored;
    return fs::exists(fs::path(store) / "worlds" / (task.key + ".world"), ignored) &&
           (!record.islands || fs::exists(fs::path(store) / "islands" / (task.key + ".json"), ignored));
}

bool allMade(const std::string& store, const JobRecord& record) {
    return std::all_of(record.tasks.begin(), record.tasks.end(), [&](const JobTask& task) { return isMade(store, record, task); });
}

}  // namespace rubble::io
