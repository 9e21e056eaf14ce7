using System.CommandLine;
using NeuronMocap.UnityPackager;
using NeuronMocap.UnityPackager.Archives;
using NeuronMocap.UnityPackager.Checks;

const int Done = 0;
const int Failed = 1;
const int BadUsage = 2;

var command = new PackagerCommand();
command.SetAction(Run);
ParseResult result = command.Parse(args);
if (result.Errors.Count > 0)
{
    Console.Error.WriteLine(string.Join(Environment.NewLine, result.Errors.Select(error => error.Message)));
    return BadUsage;
}

return result.Invoke(new InvocationConfiguration { EnableDefaultExceptionHandler = false });

int Run(ParseResult parsed)
{
    try
    {
        string repository = parsed.GetValue(command.Repository)?.FullName ?? FindRepository();
        var folder = new PackageFolder(Path.Combine(repository, "unity-package"));
        if (parsed.GetValue(command.Guid) is { } path)
            Console.WriteLine(folder.GuidOf(path));
        else if (parsed.GetValue(command.Metas))
            UpdateMetas(folder);
        else
            Deliver(parsed, repository, Stage(parsed, repository, folder));

        return Done;
    }
    catch (Exception exception) when (exception is PackagerException or IOException or UnauthorizedAccessException)
    {
        Console.Error.WriteLine(exception.Message);
        return Failed;
    }
}

static string FindRepository()
{
    for (DirectoryInfo? folder = new("."); folder is not null; folder = folder.Parent)
    {
        if (File.Exists(Path.Combine(folder.FullName, "unity-package", "package.json")))
            return folder.FullName;
    }

    throw new PackagerException("No folder unity-package is here or above; name the root of the repository with --repository.");
}

static void UpdateMetas(PackageFolder folder)
{
    foreach (string meta in folder.OrphanMetas)
    {
        File.Delete(folder.FullPath(meta));
        Console.WriteLine($"removed {meta}");
    }

    foreach (string meta in folder.AddMissingMetas())
        Console.WriteLine($"added {meta}");
}

StagedPackage Stage(ParseResult parsed, string repository, PackageFolder folder)
{
    string configuration = parsed.GetValue(command.Configuration)!;
    if (!parsed.GetValue(command.NoBuild))
    {
        Console.Error.WriteLine("building the libraries");
        LibraryBuild.Run(repository, configuration);
    }

    StagedPackage package = StagedPackage.Load(folder, repository, configuration);
    IReadOnlyList<string> problems = PackageLint.Check(package);
    return problems.Count == 0 ? package : throw new PackagerException(string.Join(Environment.NewLine, problems));
}

void Deliver(ParseResult parsed, string repository, StagedPackage package)
{
    bool isElsewhere = false;
    if (parsed.GetValue(command.InPlace))
    {
        PackageInstaller.CompleteInPlace(Path.Combine(repository, "unity-package"), package);
        Console.WriteLine("unity-package is complete");
        isElsewhere = true;
    }

    if (parsed.GetValue(command.Install) is { } project)
    {
        Console.WriteLine(PackageInstaller.InstallInto(project.FullName, package));
        isElsewhere = true;
    }

    if (parsed.GetValue(command.Branch) is { } branch)
    {
        (string commit, bool isNew) = new GitBranch(repository).Commit(package, branch);
        Console.WriteLine($"{branch} is {commit}{(isNew ? string.Empty : ", as before")}");
        isElsewhere = true;
    }

    DirectoryInfo? output = parsed.GetValue(command.Output);
    if (output is not null || !isElsewhere)
        ArchiveWriter.Write(package, output?.FullName ?? Path.Combine(repository, "artifacts", "unity"));
}
