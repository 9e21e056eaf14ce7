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
/// <c>time</c>, <c>avatar</c>, <c>frame</c>, <c>arrival</c>, then seven for each bone, from <c>Hips_x</c> to <c>Hips_qw</c>.
/// </para>
/// <para>
/// Numbers have a decimal point and as few digits as identify their binary32 value. A quaternion and its negative describe the same rotation. The
/// writer chooses the one that is nearer to that of the avatar's previous row, so that columns do not jump.
/// </para>
/// <para>
/// If the stream fails, for example on a full disk, the writer writes nothing more. Every later call throws an <see cref="IOException"/>, and
/// <see cref="Dispose"/> only closes the stream. The file may end within a row.
/// </para>
/// </remarks>
public sealed class PoseCsvWriter : IDisposable
{
    // The avatars whose last rotations are remembered. A stream with more is not a performance.
    private const int MostFollowed = 1024;

    private readonly RowOutput _output;
    private readonly bool _isZUp;
    private readonly bool _isInMetres;
    private readonly Dictionary<int, Quaternion[]> _lastRotations = [];

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
    /// <exception cref="ArgumentException">The stream is not writable.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public PoseCsvWriter(Stream stream, PoseCsvOptions? options = null, bool leaveOpen = false)
    {
        ArgumentNullException.ThrowIfNull(stream);
        if (!stream.CanWrite)
            throw new ArgumentException("The stream is not writable.", nameof(stream));

        options ??= new PoseCsvOptions();
        _output = new RowOutput(stream, leaveOpen, 1 + TextDigits.MaxSize);
        _isZUp = options.UpAxis == UpAxis.Z;
        _isInMetres = options.Unit == LengthUnit.Metres;
        try
        {
            _output.Write(PoseCsvHeader.Create(options));
            _output.Flush();
        }
        catch
        {
            // Nobody else can close the stream.
            if (!leaveOpen)
                stream.Dispose();

            throw;
        }
    }

    /// <summary>Number of rows written so far. After a failure, the stream may hold fewer.</summary>
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
    /// <exception cref="IOException">The stream fails, or failed before.</exception>
    public void WriteRow(TimeSpan time, ReadOnlySpan<BoneTransform> world, int avatarIndex = 0, long? frameIndex = null, TimeSpan? arrival = null)
    {
        ForwardKinematics.CheckPose(world, nameof(world));
        ObjectDisposedException.ThrowIf(_output.IsDisposed, this);

        _output.Advance(PoseCsvNumbers.WriteSeconds(_output.Free, time));
        _output.Write(","u8);
        _output.Advance(PoseCsvNumbers.WriteWhole(_output.Free, avatarIndex));
        _output.Write(","u8);
        if (frameIndex is { } frame)
            _output.Advance(PoseCsvNumbers.WriteWhole(_output.Free, frame));

        _output.Write(","u8);
        if (arrival is { } received)
            _output.Advance(PoseCsvNumbers.WriteSeconds(_output.Free, received));

        Quaternion[]? last = FindLastRotations(avatarIndex);
        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
        {
            Vector3 position = world[bone].Position;
            Write(_isInMetres ? new Vector3(position.X / 100, position.Y / 100, position.Z / 100) : position);
            Quaternion rotation = Follow(last, bone, world[bone].Rotation);
            Write(new Vector3(rotation.X, rotation.Y, rotation.Z));
            Write(rotation.W);
        }

        _output.Write("\n"u8);
        RowCount++;
    }

    /// <summary>Passes the rows written so far to the stream.</summary>
    /// <exception cref="IOException">The stream fails, or failed before.</exception>
    public void Flush() => _output.Flush();

    /// <summary>Writes the rest of the rows and closes the stream. After a failure of the stream, this only closes it.</summary>
    /// <exception cref="IOException">The stream fails. It is closed nevertheless.</exception>
    public void Dispose() => _output.Dispose();

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
        Span<byte> text = _output.Free;
        text[0] = (byte)',';
        _output.Advance(1 + TextDigits.Write(text[1..], value, decimals: 0));
    }
}
