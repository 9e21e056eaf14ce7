using System.Numerics;
using NeuronMocap.Files;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Csv;

/// <summary>
/// Writes a table of poses of any length: times, positions and rotations of the 59 bones in the world. It needs constant memory. Not thread-safe.
/// </summary>
/// <remarks>
/// <para>
/// The file is UTF-8 text. Lines that begin with <c>#</c> state units, axes and the source. The next line has the names of the columns:
/// <c>time</c>, <c>avatar</c>, <c>frame</c>, then seven for each bone, from <c>Hips_x</c> to <c>Hips_qw</c>.
/// </para>
/// <para>
/// Numbers have a decimal point and as few digits as identify their binary32 value. A quaternion and its negative describe the same rotation. The
/// writer chooses the one that is nearer to that of the avatar's previous row, so that columns do not jump.
/// </para>
/// </remarks>
public sealed class PoseCsvWriter : IDisposable
{
    private const int BufferSize = 1 << 16;
    private const int LongestPrefix = 128;
    private const int ValuesOfBone = 7;

    // A row of the longest numbers.
    private const int LongestRow = LongestPrefix + (BoneHierarchy.BoneCount * ValuesOfBone * (TextDigits.MaxSize + 1));

    // The avatars whose last rotations are remembered. A stream with more is not a performance.
    private const int MostFollowed = 1024;

    private readonly Stream _stream;
    private readonly bool _leavesOpen;
    private readonly bool _isZUp;
    private readonly bool _isInMetres;
    private readonly byte[] _buffer = new byte[BufferSize + LongestRow];
    private readonly Dictionary<int, Quaternion[]> _lastRotations = [];
    private int _length;
    private bool _isDisposed;

    /// <summary>Creates a file and writes the comments and the names of the columns. The file is complete after the writer is disposed.</summary>
    /// <param name="path">The path of the file. An existing file is replaced.</param>
    /// <param name="options">Units, axes and source; null for metres and Y up.</param>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to write the file.</exception>
    public PoseCsvWriter(string path, PoseCsvOptions? options = null)
        : this(WritableFile.Create(path), options)
    {
    }

    /// <summary>Writes the comments and the names of the columns to a stream.</summary>
    /// <param name="stream">The stream to write, from its current position.</param>
    /// <param name="options">Units, axes and source; null for metres and Y up.</param>
    /// <param name="leaveOpen">Whether the stream stays open when the writer is disposed.</param>
    /// <exception cref="IOException">The stream fails.</exception>
    public PoseCsvWriter(Stream stream, PoseCsvOptions? options = null, bool leaveOpen = false)
    {
        ArgumentNullException.ThrowIfNull(stream);
        options ??= new PoseCsvOptions();
        _stream = stream;
        _leavesOpen = leaveOpen;
        _isZUp = options.UpAxis == UpAxis.Z;
        _isInMetres = options.Unit == LengthUnit.Metres;
        _stream.Write(PoseCsvHeader.Create(options));
    }

    /// <summary>Number of rows written so far.</summary>
    public long RowCount { get; private set; }

    /// <summary>Writes a row.</summary>
    /// <param name="time">Time since the start. It is written with up to seven decimals.</param>
    /// <param name="world">59 transforms in the world, in <see cref="Bone"/> order, as <see cref="MotionFrame.CopyWorldTransforms(Span{BoneTransform})"/>
    /// gives them. Values that are not finite are written as <c>NaN</c>, <c>Infinity</c> and <c>-Infinity</c>.</param>
    /// <param name="avatarIndex">Number of the avatar.</param>
    /// <param name="frameIndex">Number of the frame. Null leaves the value empty.</param>
    /// <param name="arrival">Time since the start at which the frame was received. Null leaves the value empty.</param>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms.</exception>
    /// <exception cref="ObjectDisposedException">The writer is disposed.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public void WriteRow(TimeSpan time, ReadOnlySpan<BoneTransform> world, int avatarIndex = 0, long? frameIndex = null, TimeSpan? arrival = null)
    {
        ForwardKinematics.CheckPose(world, nameof(world));
        ObjectDisposedException.ThrowIf(_isDisposed, this);

        _length += PoseCsvNumbers.WriteSeconds(_buffer.AsSpan(_length), time);
        _buffer[_length++] = (byte)',';
        _length += PoseCsvNumbers.WriteWhole(_buffer.AsSpan(_length), avatarIndex);
        _buffer[_length++] = (byte)',';
        if (frameIndex is { } frame)
            _length += PoseCsvNumbers.WriteWhole(_buffer.AsSpan(_length), frame);

        _buffer[_length++] = (byte)',';
        if (arrival is { } received)
            _length += PoseCsvNumbers.WriteSeconds(_buffer.AsSpan(_length), received);

        Quaternion[]? last = FindLastRotations(avatarIndex);
        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
        {
            Vector3 position = world[bone].Position;
            Write(_isInMetres ? new Vector3(position.X / 100, position.Y / 100, position.Z / 100) : position);
            Quaternion rotation = Follow(last, bone, world[bone].Rotation);
            Write(new Vector3(rotation.X, rotation.Y, rotation.Z));
            Write(rotation.W);
        }

        _buffer[_length++] = (byte)'\n';
        RowCount++;
        if (_length >= BufferSize)
            Flush();
    }

    /// <summary>Passes the rows written so far to the stream.</summary>
    /// <exception cref="IOException">The stream fails.</exception>
    public void Flush()
    {
        _stream.Write(_buffer, 0, _length);
        _length = 0;
    }

    /// <summary>Writes the rest of the rows and closes the stream.</summary>
    /// <exception cref="IOException">The stream fails.</exception>
    public void Dispose()
    {
        if (_isDisposed)
            return;

        _isDisposed = true;
        try
        {
            Flush();
        }
        finally
        {
            if (!_leavesOpen)
                _stream.Dispose();
        }
    }
    private Quaternion[]? FindLastRotations(int avatarIndex)
    {
        if (!_lastRotations.TryGetValue(avatarIndex, out Quaternion[]? last) && _lastRotations.Count < MostFollowed)
        {
            // The first row has positive scalars.
            last = new Quaternion[BoneHierarchy.BoneCount];
            Array.Fill(last, Quaternion.Identity);
            _lastRotations.Add(avatarIndex, last);
        }

        return last;
    }

    private static Quaternion Follow(Quaternion[]? last, int bone, Quaternion rotation)
    {
        if (Quaternion.Dot(rotation, last?[bone] ?? Quaternion.Identity) < 0)
            rotation = -rotation;

        // A value that is not finite is followed by nothing.
        if (last is not null && rotation.LengthSquared() is > 0 and < 2)
            last[bone] = rotation;

        return rotation;
    }

    // A cyclic exchange of the axes is a rotation. It rounds nothing, and applies to the vector part of a quaternion as well.
    private void Write(Vector3 vector)
    {
        Write(_isZUp ? vector.Z : vector.X);
        Write(_isZUp ? vector.X : vector.Y);
        Write(_isZUp ? vector.Y : vector.Z);
    }

    private void Write(float value)
    {
        _buffer[_length++] = (byte)',';
        _length += TextDigits.Write(_buffer.AsSpan(_length), value, decimals: 0);
    }
}
