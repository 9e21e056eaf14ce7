using System.Diagnostics;
using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Files;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Recording;

namespace NeuronMocap.Tests.Files;

// A file has one writer, whatever its format and the name by which it is opened.
public sealed class OneWriterTests : IDisposable
{
    private readonly RecordingFolder _folder = new();

    private string Take => _folder.PathOf("take");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void A_second_writer_is_refused_until_the_first_ends()
    {
        using (FileStream first = WritableFile.Create(Take))
        {
            first.Write("precious"u8);
            AssertRefused(Take, () => WritableFile.Create(Take));
            AssertRefused(Take, () => WritableFile.OpenOrCreate(Take));
            Assert.Equal("precious", ReadShared(Take));
            first.Write(" words"u8);
        }

        Assert.Equal("precious words", ReadShared(Take));
        using FileStream second = WritableFile.Create(Take);
        Assert.Equal(0, second.Length);
    }

    [Fact]
    public void A_link_is_the_same_file()
    {
        string link = _folder.PathOf("link");
        using FileStream first = WritableFile.Create(Take);
        File.CreateSymbolicLink(link, Take);
        AssertRefused(link, () => WritableFile.Create(link));
        Assert.SkipUnless(TryLink(Take, _folder.PathOf("hard")), "No ln.");
        AssertRefused(_folder.PathOf("hard"), () => WritableFile.OpenOrCreate(_folder.PathOf("hard")));
    }

    [Fact]
    public void Every_kind_of_writer_refuses_the_others_file()
    {
        using var reader = new NeuronReader(new NeuronReaderOptions());
        using StreamRecorder recorder = reader.StartRecording(Take, new RecordingOptions { Overwrite = true });
        AssertRefused(Take, () => reader.StartRecording(Take, new RecordingOptions { Overwrite = true }));
        AssertRefused(Take, () => reader.ExportBvh(Take, new BvhExportOptions { Overwrite = true }));
        AssertRefused(Take, () => new CalculationFileWriter(Take, CalculationFrame.FullValueCount));
        AssertRefused(Take, () => new BvhTakeWriter(Take));
        recorder.Dispose();
        using (RecordingReader written = RecordingReader.Open(Take))
            Assert.True(written.IsComplete);

        using BvhExport export = reader.ExportBvh(Take, new BvhExportOptions { Overwrite = true });
        AssertRefused(Take, () => reader.ExportBvh(Take, new BvhExportOptions { Overwrite = true }));
    }

    [Fact]
    public void A_reader_does_not_release_the_writers_lock()
    {
        using FileStream first = WritableFile.Create(Take);
        Assert.Empty(ReadShared(Take));
        AssertRefused(Take, () => WritableFile.Create(Take));
        using var growing = new FileStream(Take, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
        AssertRefused(Take, () => WritableFile.Create(Take));
    }

    // For systems without locks on open files.
    [Fact]
    public void An_open_file_is_detected_without_locks()
    {
        Assert.True(FileWriterLock.CanBeOpenedAlone(Take));
        using (WritableFile.Create(Take))
            Assert.False(FileWriterLock.CanBeOpenedAlone(Take));

        Assert.True(FileWriterLock.CanBeOpenedAlone(Take));
    }

    private static void AssertRefused(string path, Func<IDisposable> open)
    {
        IOException refused = Assert.Throws<IOException>(() => open().Dispose());
        Assert.Contains(path, refused.Message, StringComparison.Ordinal);
        Assert.Equal(unchecked((int)0x8007_0020), refused.HResult);
    }

    private static string ReadShared(string path)
    {
        using var reader = new StreamReader(new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete));
        return reader.ReadToEnd();
    }

    private static bool TryLink(string path, string link)
    {
        if (OperatingSystem.IsWindows())
            return false;

        using Process linking = Process.Start("ln", [path, link]);
        linking.WaitForExit();
        return linking.ExitCode == 0;
    }
}
