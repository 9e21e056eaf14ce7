using System.CommandLine;
using NeuronMocap.UnityPackager;

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
        else
            UpdateMetas(folder);

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
