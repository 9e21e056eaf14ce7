using NeuronMocap.Bvh;
using NeuronMocap.Tests.Mono;

namespace NeuronMocap.Compatibility.Tests.Mono;

/// <summary>BVH files written on Mono. Mono's conversions between floats and text round twice, so the library does not use them.</summary>
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
                    float value = read.GetValues(i).ToArray()[0];
                    bool isSame = BitConverter.ToInt32(BitConverter.GetBytes(value), 0) == BitConverter.ToInt32(BitConverter.GetBytes(values[i]), 0);
                    different += isSame || (float.IsNaN(value) && float.IsNaN(values[i])) ? 0 : 1;
                }

                Console.WriteLine(sum);
                Console.WriteLine(different);
            }
        }
        """;

    private const string ReadingProgram =
        """
        using System;
        using NeuronMocap.Bvh;

        public static class Program
        {
            public static void Main(string[] arguments)
            {
                BvhDocument document = BvhDocument.Load(arguments[0]);
                uint sum = 0;
                for (int i = 0; i < document.FrameCount; i++)
                {
                    float value = document.GetValues(i).ToArray()[0];
                    sum = sum * 31 + (float.IsNaN(value) ? 1 : BitConverter.ToUInt32(BitConverter.GetBytes(value), 0));
                }

                Console.WriteLine(document.FrameCount + " " + document.RepairCount + " " + sum + " " + document.FrameTime);
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

    // Numbers that our own writers never produce: any digits, exponents, halves between two floats, and other programs' texts for NaN.
    [Fact]
    public async Task Mono_reads_any_text_as_the_same_values()
    {
        MonoProgram.Require();
        using var program = new MonoProgram();
        await program.CompileAsync(ReadingProgram);
        string path = Path.Combine(Path.GetTempPath(), $"neuronmocap-{Guid.NewGuid():N}.bvh");
        try
        {
            await File.WriteAllTextAsync(path, Hierarchy + string.Join('\n', Words()), TestContext.Current.CancellationToken);
            BvhDocument document = BvhDocument.Load(path);
            uint sum = 0;
            for (int i = 0; i < document.FrameCount; i++)
                sum = (sum * 31) + (float.IsNaN(document.GetValues(i)[0]) ? 1 : BitConverter.SingleToUInt32Bits(document.GetValues(i)[0]));

            Assert.Equal(Words().Count(), document.FrameCount);
            Assert.Equal([$"{document.FrameCount} {document.RepairCount} {sum} {document.FrameTime}"], await program.RunAsync(path));
        }
        finally
        {
            File.Delete(path);
        }
    }

    private static IEnumerable<string> Words()
    {
        foreach (string word in (string[])["nan", "-inf", "1.#QNAN", "-0.0", "1e39", "1e-46", "+.5", "5.", "16777217", "16777217.000000000001", "7.00649232162408535461e-46"])
            yield return word;

        var random = new Random(8);
        for (int i = 0; i < 20_000; i++)
        {
            string digits = string.Concat(Enumerable.Range(0, random.Next(1, 24)).Select(_ => random.Next(10)));
            string fraction = string.Concat(Enumerable.Range(0, random.Next(0, 20)).Select(_ => random.Next(10)));
            string exponent = random.Next(3) == 0 ? FormattableString.Invariant($"e{random.Next(-50, 30)}") : "";
            yield return $"{(random.Next(2) == 0 ? "-" : "")}{(random.Next(3) == 0 ? digits : digits[..Math.Min(3, digits.Length)])}.{fraction}{exponent}";
        }
    }

    // The same computation as in the program.
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
