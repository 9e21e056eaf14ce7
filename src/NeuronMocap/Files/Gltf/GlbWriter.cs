using NeuronMocap.Figures;
using NeuronMocap.Files;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Gltf;

/// <summary>
/// Writes a GLB file, the binary form of glTF 2.0: for each avatar a skeleton, a skinned figure, and one animation. Not thread-safe.
/// </summary>
/// <remarks>
/// <para>Axes are those of the stream: right-handed, Y up, the figure faces Z. Lengths are in metres. Nodes have the names of the bones.</para>
/// <para>
/// The file is written when the writer is disposed, because it begins with the number of keys. Until then, keys beyond 32 MB are in a temporary
/// file, so a take of any length needs the same memory. A file holds at most 4 GiB, which is about ten hours at 120 Hz with a key for each frame.
/// </para>
/// </remarks>
public sealed class GlbWriter : IDisposable
{
    // Room for the figure of an avatar and its description, in bytes.
    private const int FigureSize = 1 << 20;
    private const int BufferSize = 1 << 16;
    private const string UsualName = "Avatar";

    private readonly List<GlbAvatar> _avatars = [];
    private readonly Stream _stream;
    private readonly GlbOptions _options;
    private readonly bool _leavesOpen;
    private readonly KeySpool _spool;
    private bool _isDisposed;

    /// <summary>Creates a file.</summary>
    /// <param name="path">The path of the file. An existing file is replaced.</param>
    /// <param name="options">The keys of the animations; null for a key for each frame.</param>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to write the file.</exception>
    public GlbWriter(string path, GlbOptions? options = null)
        : this(WritableFile.Create(path), options)
    {
    }

    /// <summary>Writes to a stream.</summary>
    /// <param name="stream">The stream to write, from its current position. It need not seek.</param>
    /// <param name="options">The keys of the animations; null for a key for each frame.</param>
    /// <param name="leaveOpen">Whether the stream stays open when the writer is disposed.</param>
    /// <exception cref="ArgumentException">The stream is not writable.</exception>
    public GlbWriter(Stream stream, GlbOptions? options = null, bool leaveOpen = false)
        : this(stream, options, leaveOpen, new KeySpool())
    {
    }

    internal GlbWriter(Stream stream, GlbOptions? options, bool leaveOpen, KeySpool spool)
    {
        ArgumentNullException.ThrowIfNull(stream);
        if (!stream.CanWrite)
            throw new ArgumentException("The stream is not writable.", nameof(stream));

        _stream = stream;
        _options = options ?? new GlbOptions();
        _leavesOpen = leaveOpen;
        _spool = spool;
    }

    /// <summary>Creates a file with one figure and no animation.</summary>
    /// <param name="body">The sizes of the figure.</param>
    /// <param name="name">Name of the figure.</param>
    /// <param name="accentColor">The colour of joints and visor, 0xRRGGBB in sRGB; null for orange.</param>
    /// <returns>The bytes of the file.</returns>
    public static byte[] CreateFigure(SkeletonBody body, string name = "Figure", int? accentColor = null)
    {
        using var file = new MemoryStream();
        using (var writer = new GlbWriter(file, leaveOpen: true))
            writer.AddAvatar(name, body, accentColor);

        return file.ToArray();
    }

    /// <summary>Adds an avatar. Frames of several avatars may be added in any order.</summary>
    /// <param name="name">
    /// Name of the avatar. If it is empty, or if another avatar or a bone has it, the name in the file differs: see <see cref="GlbAvatar.Name"/>.
    /// </param>
    /// <param name="body">The sizes of the figure, and its pose before the first frame.</param>
    /// <param name="accentColor">The colour of joints and visor, 0xRRGGBB in sRGB; null for one that differs from those of other avatars.</param>
    /// <returns>The avatar, which takes frames. Without frames, its figure stands at rest.</returns>
    /// <exception cref="ObjectDisposedException">The writer is disposed.</exception>
    /// <exception cref="NeuronException">The file would become larger than 4 GiB.</exception>
    public GlbAvatar AddAvatar(string name, SkeletonBody body, int? accentColor = null)
    {
        ArgumentNullException.ThrowIfNull(name);
        ArgumentNullException.ThrowIfNull(body);
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        _spool.RequireRoom();
        _spool.Promised += FigureSize;
        int color = (accentColor ?? FigureColors.GetAccent(_avatars.Count)) & 0xFFFFFF;
        var avatar = new GlbAvatar(FindName(name), body, color, _spool, _options, () => _isDisposed);
        _avatars.Add(avatar);
        return avatar;
    }

    /// <summary>Writes the file and closes the stream.</summary>
    /// <exception cref="IOException">The stream fails.</exception>
    public void Dispose()
    {
        if (_isDisposed)
            return;

        _isDisposed = true;
        try
        {
            foreach (GlbAvatar avatar in _avatars)
                avatar.Animation.Complete();

            var buffered = new BufferedStream(_stream, BufferSize);
            new GlbDocument(_avatars).Write(buffered);
            buffered.Flush();
        }
        finally
        {
            _spool.Dispose();
            if (!_leavesOpen)
                _stream.Dispose();
        }
    }

    // Closes the stream without writing to it.
    internal void Abandon()
    {
        _isDisposed = true;
        _spool.Dispose();
        if (!_leavesOpen)
            _stream.Dispose();
    }

    // Programs find bones by their names, and rename one of two nodes with the same name.
    private string FindName(string name)
    {
        string wanted = string.IsNullOrWhiteSpace(name) ? UsualName : name;
        if (BoneHierarchy.TryFind(wanted.AsSpan(), SkeletonVariant.Neck1, out _) || BoneHierarchy.TryFind(wanted.AsSpan(), SkeletonVariant.Spine3, out _))
            wanted += " (figure)";

        string free = wanted;
        for (int number = 2; _avatars.Exists(avatar => string.Equals(avatar.Name, free, StringComparison.Ordinal)); number++)
            free = $"{wanted} ({number})";

        return free;
    }
}
