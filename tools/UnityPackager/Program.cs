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
        string repository = parsed.GetValue(command.Repository)!.FullName;
        var folder = new PackageFolder(Path.Combine(repository, "unity-package"));
        if (parsed.GetValue(command.Guid) is { } path)
            Console.WriteLine(folder.GuidOf(path));
        else if (parsed.GetValue(command.Metas))
            UpdateMetas(folder);
        else
            Deliver(parsed, repository, Stage(folder, repository, parsed.GetValue(command.Configuration)!));

        return Done;
    }
    catch (Exception exception) when (exception is PackagerException or IOException or UnauthorizedAccessException)
    {
        Console.Error.WriteLine(exception.Message);
        return Failed;
    }
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

static StagedPackage Stage(PackageFolder folder, string repository, string configuration)
{
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
