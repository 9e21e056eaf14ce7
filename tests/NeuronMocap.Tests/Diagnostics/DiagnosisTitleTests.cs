using NeuronMocap.Diagnostics;

namespace NeuronMocap.Tests.Diagnostics;

public sealed class DiagnosisTitleTests
{
    [Fact]
    public void Every_verdict_has_a_title_of_its_own()
    {
        string[] titles = [.. Enum.GetValues<DiagnosisVerdict>().Select(static verdict => new StreamDiagnosis { Verdicts = [verdict] }.Title)];

        Assert.Distinct(titles);
        Assert.All(titles, static title => Assert.NotEmpty(title));
    }
}
