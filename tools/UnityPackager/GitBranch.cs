using System.Diagnostics;
using System.Globalization;
using System.Text;

namespace NeuronMocap.UnityPackager;

/// <summary>Commits the complete package with its libraries to a separate branch, from which the package manager installs it by a git URL.</summary>
/// <remarks>
/// The work tree and its index do not change. The main branch holds no binaries, and this branch holds only the package.
/// </remarks>
internal sealed class GitBranch(string repository)
{
    private const string Folder = "unity-package";

    /// <summary>Commits the package, unless the branch already holds the same files.</summary>
    /// <returns>The commit, and whether it is new.</returns>
    public (string Commit, bool IsNew) Commit(StagedPackage package, string branch)
    {
        string reference = $"refs/heads/{branch}";
        Run($"check-ref-format --branch {branch}");
        string tree = WriteTree(package);
        string? parent = TryRun($"rev-parse --verify --quiet {reference}^{{commit}}");
        if (parent is not null && Run($"rev-parse {parent}^{{tree}}") == tree)
            return (parent, false);

        string source = Run("rev-parse HEAD");
        string message = $"{package.Name} {package.Version}, built from {source}\n";
        string commit = Run($"commit-tree {tree}{(parent is null ? string.Empty : $" -p {parent}")} -F -", message);
        Run($"update-ref {reference} {commit} {parent ?? new string('0', commit.Length)}");
        return (commit, true);
    }

    private string WriteTree(StagedPackage package)
    {
        // A folder that only this user can access, with an unpredictable name: git opens the index by its name.
        DirectoryInfo folder = Directory.CreateTempSubdirectory("unity-packager-");
        string index = Path.Combine(folder.FullName, "index");
        try
        {
            IEnumerable<string> entries = package.Files.Keys.Zip(WriteBlobs(package.Files.Values, folder.FullName), static (path, blob) => $"100644 {blob}\t{Folder}/{path}\n");
            Run("update-index --index-info", string.Concat(entries), index);
            return Run("write-tree", index: index);
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    // In one process and one pack: a process and an object of its own for each file take most of the time.
    private string[] WriteBlobs(IEnumerable<byte[]> contents, string folder)
    {
        string marks = Path.Combine(folder, "marks");
        using var stream = new MemoryStream();
        int count = 0;
        foreach (byte[] content in contents)
        {
            stream.Write(Encoding.ASCII.GetBytes($"blob\nmark :{++count}\ndata {content.Length}\n"));
            stream.Write(content);
            stream.WriteByte((byte)'\n');
        }

        Run($"fast-import --quiet --export-marks=\"{marks}\"", stream.ToArray());
        var blobs = File.ReadLines(marks).Select(static line => line.Split(' ')).ToDictionary(static mark => int.Parse(mark[0][1..], CultureInfo.InvariantCulture), static mark => mark[1]);
        return [.. Enumerable.Range(1, count).Select(mark => blobs[mark])];
    }

    private string Run(string arguments, byte[] input) => Execute(arguments, input, index: null, out string error) ?? throw new PackagerException($"git {arguments}: {error.Trim()}");

    private string Run(string arguments, string? input = null, string? index = null) =>
        Execute(arguments, Encoding.UTF8.GetBytes(input ?? string.Empty), index, out string error) ?? throw new PackagerException($"git {arguments}: {error.Trim()}");

    private string? TryRun(string arguments) => Execute(arguments, [], index: null, out _);

    private string? Execute(string arguments, byte[] input, string? index, out string error)
    {
        var start = new ProcessStartInfo("git", arguments)
        {
            WorkingDirectory = repository,
            UseShellExecute = false,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        if (index is not null)
            start.Environment["GIT_INDEX_FILE"] = index;

        using Process process = Process.Start(start) ?? throw new PackagerException("git cannot be started.");
        Task<string> errors = process.StandardError.ReadToEndAsync();
        process.StandardInput.BaseStream.Write(input);
        process.StandardInput.Close();
        string output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        error = errors.Result;
        return process.ExitCode == 0 ? output.Trim() : null;
    }
}
