using System.Globalization;
using System.Text;
using NeuronMocap.Calculation;
using NeuronMocap.Tests.Calculation;

namespace NeuronMocap.Data.Tests.Calculation;

public sealed class CalculationDocumentTests
{
    public static TheoryData<string> Takes => [.. CalculationText.Takes];

    [Theory, MemberData(nameof(Takes))]
    public void Real_takes_hold_bone_centres(string name)
    {
        CalculationDocument document = CalculationDocument.Load(Fixtures.Require("calc", name));
        Assert.Empty(CalculationSkeleton.Measure(document).Warnings);
        Assert.Null(document.InitialDirection);
        Assert.Null(document.DeclaredFrameRate);
        Assert.Equal(120, document.FrameRate);
    }

    [Theory, MemberData(nameof(Takes))]
    public void A_recording_is_read_without_repairs(string take)
    {
        byte[] text = File.ReadAllBytes(Fixtures.Require("calc", take));

        var document = CalculationDocument.Parse(text, new CalculationReadOptions { Strict = true });

        string[] lines = Encoding.ASCII.GetString(text).Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(lines.Length, document.FrameCount);
        for (int row = 0; row < lines.Length; row++)
        {
            float[] expected = [.. lines[row].Split((char[])['\t', '\r'], StringSplitOptions.RemoveEmptyEntries).Select(word => float.Parse(word, CultureInfo.InvariantCulture))];
            Assert.Equal(expected.Select(BitConverter.SingleToInt32Bits), document.GetValues(row).ToArray().Select(BitConverter.SingleToInt32Bits));
        }
    }

    [Theory, MemberData(nameof(Takes))]
    public void An_export_round_trips_byte_for_byte(string take)
    {
        byte[] text = File.ReadAllBytes(Fixtures.Require("calc", take));
        Assert.Equal(text, NeuronMocap.Tests.Calculation.CalculationDocumentTests.Write(CalculationDocument.Parse(text)));
    }
}
