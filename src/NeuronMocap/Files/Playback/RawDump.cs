namespace NeuronMocap.Recording;

/// <summary>Converts a raw dump, a file with the bytes of a stream but without times, to a recording.</summary>
public static class RawDump
{
    /// <summary>Writes all bytes of a dump to a recording, with the times at which a player would play them.</summary>
    /// <param name="path">The path of the dump.</param>
    /// <param name="writer">A recording without connections. It receives one connection, number 0, which is closed at the end.</param>
    /// <param name="options">The options, above all the frame rate; null to use the rate of the frames.</param>
    /// <param name="from">Bytes before this time, from 0, are omitted.</param>
    /// <param name="to">Bytes from this time on are omitted; null for no limit.</param>
    /// <param name="progress">Receives the progress, 0 to 1; may be null.</param>
    /// <param name="cancellationToken">Cancels the operation.</param>
    /// <exception cref="PlaybackException">The file does not contain a frame.</exception>
    /// <exception cref="ArgumentException">An option is out of range, or the file is a recording.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="from"/> is negative.</exception>
    /// <exception cref="IOException">The dump cannot be read or is a pipe, or the recording cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to read the file.</exception>
    /// <exception cref="OperationCanceledException">The operation was cancelled.</exception>
    public static void CopyTo(
        string path,
        RecordingWriter writer,
        PlaybackOptions? options = null,
        TimeSpan from = default,
        TimeSpan? to = null,
        IProgress<double>? progress = null,
        CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(writer);
        if (from < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(from), from, "A dump begins at 0 s.");

        using RecordedEventSource source = RecordedEventSource.Open(path, PlaybackOptions.CopyChecked(options));
        if (source is not RawDumpSource)
            throw new ArgumentException("The file is already a recording.", nameof(path));

        writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "", ""));
        while (source.Read() is { Kind: not RecordedEventKind.End } recorded)
        {
            cancellationToken.ThrowIfCancellationRequested();
            if (recorded.Kind == RecordedEventKind.Bytes && recorded.Time >= from && !(recorded.Time >= to))
                Write(writer, recorded.Time - from, recorded.Bytes);

            progress?.Report(source.Duration > TimeSpan.Zero ? recorded.Time / source.Duration : 0);
        }

        writer.CloseConnection(writer.Duration, 0, "The dump ends.");
    }

    // A packet may be larger than the maximum piece of a recording.
    private static void Write(RecordingWriter writer, TimeSpan time, ReadOnlySpan<byte> bytes)
    {
        while (!bytes.IsEmpty)
        {
            int length = Math.Min(bytes.Length, RecordingWriter.MaxPieceLength);
            writer.WriteBytes(time, 0, bytes[..length]);
            bytes = bytes[length..];
        }
    }
}
