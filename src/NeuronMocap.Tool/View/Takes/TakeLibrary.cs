using System.Globalization;
using System.Security.Cryptography;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>The takes that are open. Thread-safe.</summary>
/// <param name="scratch">The folder for uploads and temporary files.</param>
/// <param name="run">The start of the takes' ids. Pages outlive the program, so each run of it needs others: <see cref="NewRun"/>.</param>
/// <param name="uploadRoom">The bytes that the temporary files made of an upload may have: a small file can hold many frames.</param>
internal sealed class TakeLibrary(ScratchFolder scratch, string run, long uploadRoom) : IDisposable
{
    /// <summary>Number of takes that can be open. To open another one closes the one that was used longest ago. Uploads cannot be opened again.</summary>
    public const int MostTakes = 8;

    private readonly Lock _lock = new();
    private readonly List<Take> _takes = [];

    // Closed takes whose files stay, as they were before they were read.
    private readonly Dictionary<string, Take> _closed = new(StringComparer.Ordinal);
    private int _number;
    private bool _isDisposed;

    /// <summary>Makes a start of ids that no other run of the program has.</summary>
    public static string NewRun() => $"t{RandomNumberGenerator.GetHexString(8, lowercase: true)}-";

    /// <summary>Opens a file as a take. Its kind is determined by its contents. The file is read on another thread.</summary>
    /// <param name="path">The file.</param>
    /// <param name="name">Its name for people.</param>
    /// <param name="isUpload">Whether the file is deleted with the take.</param>
    /// <param name="order">Rotation order of a stream in the file; null for the order that the file states, or YXZ.</param>
    /// <returns>The take, whose first frames can be read soon.</returns>
    /// <exception cref="NeuronException">The file is not a take. The message is a sentence that says why.</exception>
    /// <exception cref="IOException">The file cannot be read. The message is a sentence.</exception>
    public Take Open(string path, string name, bool isUpload = false, RotationOrder? order = null)
    {
        FileKind kind = Recognize(path, name, isUpload, order);
        Take take;
        Take? oldest;
        lock (_lock)
        {
            ObjectDisposedException.ThrowIf(_isDisposed, this);
            take = new Take(string.Create(CultureInfo.InvariantCulture, $"{run}{++_number}"), name, path, kind) { IsUpload = isUpload, RotationOrder = order };
            oldest = Add(take);
            Start(take);
        }

        Close(oldest);
        return take;
    }

    /// <summary>Finds a take. One that was closed is read again if its file is not an upload. Null if there is none.</summary>
    public Take? Find(string id)
    {
        Take? take;
        Take? oldest;
        lock (_lock)
        {
            int place = _takes.FindIndex(open => string.Equals(open.Id, id, StringComparison.Ordinal));
            if (place >= 0)
            {
                take = _takes[place];
                _takes.RemoveAt(place);
                _takes.Add(take);
                return take;
            }

            if (!_closed.Remove(id, out take))
                return null;

            oldest = Add(take);
            Start(take);
        }

        Close(oldest);
        return take;
    }

    /// <summary>Finds the performer with a key, in a take that <see cref="Find"/> finds. Null if there is none.</summary>
    public async Task<TakePerformer?> FindPerformerAsync(string key, CancellationToken cancellationToken)
    {
        string? id;
        lock (_lock)
            id = _takes.Select(static take => take.Id).Concat(_closed.Keys).FirstOrDefault(known => key.StartsWith(known + "-", StringComparison.Ordinal));

        if (id is null || Find(id) is not { } take)
            return null;

        await take.WaitUntilKnownAsync(cancellationToken);
        return take.Find(key);
    }

    /// <summary>Closes all takes.</summary>
    public void Dispose()
    {
        Take[] takes;
        lock (_lock)
        {
            _isDisposed = true;
            takes = [.. _takes];
            _takes.Clear();
            _closed.Clear();
        }

        Array.ForEach(takes, Close);
    }

    private static FileKind Recognize(string path, string name, bool isUpload, RotationOrder? order)
    {
        try
        {
            FileKind kind = new FileSettings(path, Output: null) { InputOrder = order }.RecognizeInput();
            return kind == FileKind.Bvh && BvhTakeFile.FindFault(path, name) is { } fault ? throw new NeuronException(fault) : kind;
        }
        catch (NeuronException exception) when (exception is UnreadKindException || IsNamedCharacter(name))
        {
            throw new NeuronException(DescribeKind(TerminalText.Clean(name), isUpload, IsNamedCharacter(name) || exception is UnreadKindException { IsGlb: true }), exception);
        }
        catch (Exception exception) when (exception is NeuronException or IOException or UnauthorizedAccessException)
        {
            // The path of an upload means nothing to people.
            throw new NeuronException(FileFault.OfReading(exception, path).Replace(path, name, StringComparison.Ordinal), exception);
        }
    }

    private static bool IsNamedCharacter(string name) => Path.GetExtension(name).ToLowerInvariant() is ".vrm" or ".glb" or ".gltf";

    // The page uploads characters only if they have the name of a take.
    private static string DescribeKind(string name, bool isUpload, bool isCharacter) => (isCharacter, isUpload) switch
    {
        (true, false) => $"'{name}' is a character, not a take. Start view without it, and drop it on the page.",
        (true, true) => $"'{name}' is a GLB file. To show it as a character, give its name the ending .glb and drop it again.",
        _ => $"'{name}' is neither a take nor a character. Takes are BVH files, recordings (.nmrec), calculation exports (.calc) and raw streams (.bin, .dat). "
            + "Characters are VRM, GLB and glTF files.",
    };

    // Returns the take that has to be closed.
    private Take? Add(Take take)
    {
        _takes.Add(take);
        if (_takes.Count <= MostTakes)
            return null;

        Take oldest = _takes[0];
        _takes.RemoveAt(0);
        if (!oldest.IsUpload)
            _closed.Add(oldest.Id, oldest.CopyUnread());

        return oldest;
    }

    private void Start(Take take) => take.Start(new TakeReading(take, scratch.Path, take.IsUpload ? new TakeRoom(uploadRoom) : null).Run);

    private void Close(Take? take)
    {
        take?.Dispose();
        if (take is { IsUpload: true })
            scratch.Delete(take.Path);
    }
}
