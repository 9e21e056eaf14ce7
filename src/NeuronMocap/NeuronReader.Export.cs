using NeuronMocap.Bvh;

namespace NeuronMocap;

/// <content>Export to BVH files.</content>
public sealed partial class NeuronReader
{
    // The events about frames that an export lost use this name too.
    internal const string ExportQueueName = "bvh export";

    /// <summary>
    /// Writes all motion frames that arrive from now on to a BVH file, until the export or the reader is disposed. To get the first frame too, call this
    /// method before you start the reader.
    /// </summary>
    /// <remarks>
    /// The rows hold the values of the frames, bit for bit, in the rotation order of the stream. If the layout or the rotation order changes, a new file
    /// begins, with "-part2", "-part3" and so on in its name. Other consumers of the reader never wait for the disk.
    /// </remarks>
    /// <param name="path">The file. If each avatar gets its own file, the file names are derived from this path.</param>
    /// <param name="options">Which avatars to export, and facts that the stream does not contain; null for the defaults.</param>
    /// <returns>The export; dispose it to complete the file.</returns>
    /// <exception cref="ArgumentException">The path is empty, or an option is out of range.</exception>
    /// <exception cref="IOException">The file exists and must not be replaced, or is already being written, or cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to write the file.</exception>
    public BvhExport ExportBvh(string path, BvhExportOptions? options = null) => ExportBvhTo(path, options, open: null);

    // Tests replace the file with another stream.
    internal BvhExport ExportBvhTo(string path, BvhExportOptions? options, Func<string, Stream>? open)
    {
        if (string.IsNullOrWhiteSpace(path))
            throw new ArgumentException("The path must not be empty.", nameof(path));

        options = BvhExportOptions.CopyChecked(options);
        var bodies = new BvhExportBodies(options, _discovery?.Inquiry, _format);
        BvhExportFiles? files = null;
        FrameQueue? queue = null;
        BvhExport export;
        try
        {
            files = new BvhExportFiles(path, options, bodies, open);
            queue = _pipeline.OpenMotionQueue(options.Capacity, ExportQueueName);
            export = new BvhExport(path, queue, files, bodies, _recordings.OnEnded);
        }
        catch
        {
            // The file cannot be opened, or the system has no memory for the queue or no thread left.
            queue?.Dispose();
            files?.Close();
            throw;
        }

        _recordings.Add(export);
        return export;
    }
}
