using NeuronMocap.Bvh;
using NeuronMocap.Delivery;

namespace NeuronMocap;

/// <content>Motion that is kept.</content>
public sealed partial class NeuronReader
{
    // Also of the events that tell what it lost.
    internal const string ExportQueueName = "bvh export";

    /// <summary>
    /// Writes the motion frames that arrive from now on into a BVH file, until the export or the reader is disposed of. To get the first frame too, call it
    /// before the reader is started.
    /// <para>
    /// Rows are the frames' values, bit for bit, in the rotation order in which they are received. Where layout or rotation order change in the middle a new
    /// file begins, with "-part2", "-part3" and so on in its name. The reader's other consumers never wait for the disk.
    /// </para>
    /// </summary>
    /// <param name="path">The file; where there is one for each avatar, what their names are made of.</param>
    /// <param name="options">Which avatars, and what the stream does not say; null for the defaults.</param>
    /// <returns>The export; dispose of it to complete the file.</returns>
    /// <exception cref="ArgumentException">The path is empty, or an option is out of its range.</exception>
    /// <exception cref="IOException">The file is there already and shall not be replaced, or it cannot be written, or is being written already.</exception>
    /// <exception cref="UnauthorizedAccessException">This user may not write it.</exception>
    public BvhExport ExportBvh(string path, BvhExportOptions? options = null) => ExportBvhTo(path, options, open: null);

    // Tests put something else in a file's place.
    internal BvhExport ExportBvhTo(string path, BvhExportOptions? options, Func<string, Stream>? open)
    {
        if (string.IsNullOrWhiteSpace(path))
            throw new ArgumentException("A file has a name.", nameof(path));

        options ??= new BvhExportOptions();
        if (options.HeaderTimeout < TimeSpan.Zero || options.HeaderTimeout > TimeSpan.FromMinutes(5))
            throw new ArgumentOutOfRangeException(nameof(options), options.HeaderTimeout, "HeaderTimeout is 0 to 5 minutes.");
        if (options.Capacity is < 1 or > 1 << 20)
            throw new ArgumentOutOfRangeException(nameof(options), options.Capacity, "Capacity is 1 to 1,048,576 frames.");
        if (options.FrameTime == default(BvhFrameTime))
            throw new ArgumentException("FrameTime is above 0, or null.", nameof(options));

        var bodies = new BvhExportBodies(options, _options.Commands, _format);
        BvhExportFiles? files = null;
        FrameQueue? queue = null;
        BvhExport export;
        try
        {
            files = new BvhExportFiles(path, options, bodies, open);
            queue = _pipeline.OpenMotionQueue(options.Capacity, ExportQueueName, out MotionOnlyConsumer intake);
            export = new BvhExport(path, queue, intake, files, bodies, _recordings.OnEnded);
        }
        catch
        {
            // The file cannot be opened, or there is no memory for the queue, or no thread.
            queue?.Dispose();
            files?.Close();
            bodies.Dispose();
            throw;
        }

        _recordings.Add(export);
        return export;
    }
}
