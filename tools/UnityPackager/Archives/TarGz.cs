using System.Formats.Tar;
using System.IO.Compression;

namespace NeuronMocap.UnityPackager.Archives;

/// <summary>
/// A gzipped tar whose bytes depend only on the names and contents of the files. It has no times, owners or traces of the computer.
/// </summary>
internal static class TarGz
{
    // The time that npm gives all files of its archives.
    private static readonly DateTimeOffset Time = new(1985, 10, 26, 8, 15, 0, TimeSpan.Zero);

    /// <summary>Writes entries in the given order.</summary>
    /// <param name="entries">Names and contents. Names of folders end in '/', and folders have no content.</param>
    public static byte[] Create(IEnumerable<(string Name, byte[]? Content)> entries)
    {
        var bytes = new MemoryStream();
        using (var gzip = new GZipStream(bytes, CompressionLevel.SmallestSize, leaveOpen: true))
        using (var tar = new TarWriter(gzip, TarEntryFormat.Ustar))
        {
            foreach ((string name, byte[]? content) in entries)
                tar.WriteEntry(CreateEntry(name, content));
        }

        return bytes.ToArray();
    }

    /// <summary>Reads the files of an archive. Folders are left out.</summary>
    /// <exception cref="PackagerException">Two entries have the same name.</exception>
    public static Dictionary<string, byte[]> Read(byte[] archive)
    {
        var files = new Dictionary<string, byte[]>(StringComparer.Ordinal);
        using var gzip = new GZipStream(new MemoryStream(archive), CompressionMode.Decompress);
        using var tar = new TarReader(gzip);
        while (tar.GetNextEntry(copyData: true) is { } entry)
        {
            if (entry.EntryType is TarEntryType.Directory)
                continue;

            var content = new MemoryStream();
            entry.DataStream?.CopyTo(content);
            if (!files.TryAdd(entry.Name, content.ToArray()))
                throw new PackagerException($"The archive holds {entry.Name} twice.");
        }

        return files;
    }

    private static UstarTarEntry CreateEntry(string name, byte[]? content)
    {
        const UnixFileMode file = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.GroupRead | UnixFileMode.OtherRead;
        const UnixFileMode folder = file | UnixFileMode.UserExecute | UnixFileMode.GroupExecute | UnixFileMode.OtherExecute;
        var entry = new UstarTarEntry(content is null ? TarEntryType.Directory : TarEntryType.RegularFile, name)
        {
            ModificationTime = Time,
            Mode = content is null ? folder : file,
        };
        if (content is not null)
            entry.DataStream = new MemoryStream(content);

        return entry;
    }
}
