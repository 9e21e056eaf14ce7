using NeuronMocap.Bvh;

namespace NeuronMocap.Compatibility.Tests.Mono;

/// <summary>BVH files that Mono writes: its own conversions between floats and text round twice, and the library uses none of them.</summary>
public sealed class MonoBvhTests
{
    private const string Hierarchy = "HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nCHANNELS 1 Xposition\n}\nMOTION\nFrames: 0\nFrame Time: 0.008\n";

    private const string Program =
        """
        using System;
        using System.IO;
        using System.Text;
        using NeuronMocap.Bvh;

        public static class Program
        {
            public static void Main(string[] arguments)
            {
                BvhDocument empty = BvhDocument.Load(new MemoryStream(Encoding.ASCII.GetBytes(arguments[0])));
                float[] values = new float[20000];
                uint bits = 1;
                for (int i = 0; i < values.Length; i++)
                {
                    bits = bits * 1664525 + 1013904223;
                    values[i] = i % 2 == 0 ? BitConverter.ToSingle(BitConverter.GetBytes(bits), 0) : (bits >> 8) / 65536f - 128;
                }

                var written = new MemoryStream();
                new BvhDocument(empty.Hierarchy, empty.FrameTime, values).Save(written);
                uint sum = 0;
                foreach (byte letter in written.ToArray())
                    sum = sum * 31 + letter;

                written.Position = 0;
                BvhDocument read = BvhDocument.Load(written);
                int different = 0;
                for (int i = 0; i < values.Length; i++)
                {
                    float value = read.GetFrame(i).ToArray()[0];
                    bool isSame = BitConverter.ToInt32(BitConverter.GetBytes(value), 0) == BitConverter.ToInt32(BitConverter.GetBytes(values[i]), 0);
                    different += isSame || (float.IsNaN(value) && float.IsNaN(values[i])) ? 0 : 1;
                }

                Console.WriteLine(sum);
                Console.WriteLine(different);
            }
        }
        """;

    [Fact]
    public async Task Mono_writes_the_same_text_and_reads_the_same_values()
    {
        MonoProgram.Require();
        using var program = new MonoProgram();
        await program.CompileAsync(Program);

        Assert.Equal([$"{SumOfWritten()}", "0"], await program.RunAsync(Hierarchy));
    }

    // As the program does it.
    private static uint SumOfWritten()
    {
        BvhDocument empty = BvhDocument.Parse(System.Text.Encoding.ASCII.GetBytes(Hierarchy));
        float[] values = new float[20_000];
        uint bits = 1;
        for (int i = 0; i < values.Length; i++)
        {
            bits = (bits * 1_664_525) + 1_013_904_223;
            values[i] = i % 2 == 0 ? BitConverter.UInt32BitsToSingle(bits) : ((bits >> 8) / 65536f) - 128;
        }

        using var written = new MemoryStream();
        new BvhDocument(empty.Hierarchy, empty.FrameTime, values).Save(written);
        return written.ToArray().Aggregate(0u, static (sum, letter) => (sum * 31) + letter);
    }
}
