namespace NeuronMocap.Bvh;

internal static class BvhFile
{
    // Without a buffer of its own: what is written is the system's, and outlives the process. Others may read meanwhile, as one looks at a log.
    private const int NoBuffer = 1;

    public static FileStream Create(string path, bool isOverwriting)
    {
        ArgumentNullException.ThrowIfNull(path);
        return new FileStream(path, isOverwriting ? FileMode.Create : FileMode.CreateNew, FileAccess.Write, FileShare.Read | FileShare.Delete, NoBuffer);
    }
}
