namespace NeuronMocap.Recording;

/// <summary>The bytes of a stream that somebody wrote to a file without times, made a recording.</summary>
public static class RawDump
{
    /// <summary>Writes the bytes into a recording, all of them, with the times at which they would be played.</summary>
    /// <param name="path">The dump.</param>
    /// <param name="writer">A recording without connections; it gets one, number 0, that is closed at the end.</param>
    /// <param name="options">How to read the dump, above all its rate; null for what its frames say.</param>
    /// <param name="from">Bytes before this time are left out.</param>
    /// <param name="to">Bytes from this time on are left out; null for none.</param>
    /// <param name="progress">Told the part that is done, 0 to 1; null for nobody.</param>
    /// <param name="cancellationToken">Ends it.</param>
    /// <exception cref="PlaybackException">There is no frame in the file.</exception>
    /// <exception cref="ArgumentException">An option is out of its range, or the file is a recording.</exception>
    /// <exception cref="IOException">The dump cannot be read, or the recording cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The file may not be read.</exception>
    /// <exception cref="OperationCanceledException">It was ended.</exception>
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
        using RecordedEventSource source = RecordedEventSource.Open(path, PlaybackOptions.CopyChecked(options));
        if (source is not RawDumpSource)
            throw new ArgumentException("The file is a recording already.", nameof(path));

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

    // A packet may be larger than a piece of a recording.
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
