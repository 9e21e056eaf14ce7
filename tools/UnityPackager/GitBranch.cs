using System.Diagnostics;

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
            IEnumerable<string> entries = package.Files.Select(file => $"100644 {WriteBlob(file.Value)}\t{Folder}/{file.Key}\n");
            Run("update-index --index-info", string.Concat(entries), index);
            return Run("write-tree", index: index);
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    private string WriteBlob(byte[] content) => Run("hash-object -w --stdin --no-filters", content);

    private string Run(string arguments, string? input = null, string? index = null) => Run(arguments, input is null ? null : System.Text.Encoding.UTF8.GetBytes(input), index);

    private string Run(string arguments, byte[]? input, string? index = null) =>
        Execute(arguments, input, index, out string error) ?? throw new PackagerException($"git {arguments}: {error.Trim()}");

    private string? TryRun(string arguments) => Execute(arguments, input: null, index: null, out _);

    private string? Execute(string arguments, byte[]? input, string? index, out string error)
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
        process.StandardInput.BaseStream.Write(input ?? []);
        process.StandardInput.Close();
        string output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        error = errors.Result;
        return process.ExitCode == 0 ? output.Trim() : null;
    }
}
