namespace NeuronMocap.Bvh;

internal static class BvhFile
{
    // Without a buffer of its own: what is written is the system's, and outlives the process. Others may read meanwhile, as one looks at a log.
    private const int NoBuffer = 1;
    private const FileShare Sharing = FileShare.Read | FileShare.Delete;

    /// <summary>An empty file, whatever was there.</summary>
    public static FileStream Create(string path)
    {
        ArgumentNullException.ThrowIfNull(path);
        return new FileStream(path, FileMode.Create, FileAccess.Write, Sharing, NoBuffer);
    }

    /// <summary>A new file, or one that is to be replaced and still holds what it did.</summary>
    public static FileStream Open(string path, bool isReplacing)
    {
        ArgumentNullException.ThrowIfNull(path);
        return new FileStream(path, isReplacing ? FileMode.OpenOrCreate : FileMode.CreateNew, FileAccess.Write, Sharing, NoBuffer);
    }
}
