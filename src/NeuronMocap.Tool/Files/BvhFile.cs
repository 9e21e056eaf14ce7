using NeuronMocap.Bvh;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Files;

/// <summary>Reads BVH files with progress. Ctrl+C cancels the reading.</summary>
internal static class BvhFile
{
    private const int MaxListed = 6;

    /// <summary>Reads a file.</summary>
    /// <exception cref="NeuronException">The file is not BVH, or it has rows and none can be read. The message then has the reason of the first.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static BvhDocument Load(string path, IProgress<double> progress, CancellationToken cancellationToken)
    {
        var options = new BvhReadOptions { Progress = new ReadProgress(new FileInfo(path).Length, progress, cancellationToken) };
        BvhDocument document = BvhDocument.Load(path, options);
        RequireRows(document);
        return document;
    }

    /// <summary>Throws if the file has rows and none can be read. A file that holds only a skeleton has none.</summary>
    /// <exception cref="NeuronException">None of the rows can be read.</exception>
    public static void RequireRows(BvhDocument document)
    {
        if (document.FrameCount > 0 || document.SkippedRowCount == 0)
            return;

        BvhRepair first = document.Repairs.FirstOrDefault(static repair => repair.SkipsRow);
        string rows = document.SkippedRowCount == 1 ? "the only row cannot" : Quantity.Format($"none of the {document.SkippedRowCount:#,0} rows can");
        string reason = first.Description is null ? string.Empty : $" Line {first.Line}, column {first.Column}: {first.Description}";
        throw new NeuronException($"{rows} be read.{reason}");
    }

    /// <summary>Lists the first joints by name.</summary>
    public static string NamesOf(IReadOnlyList<BvhJoint> joints) =>
        string.Join(", ", joints.Take(MaxListed).Select(static joint => joint.Name)) + (joints.Count > MaxListed ? ", …" : string.Empty);
}
