using System.Xml.Linq;
using NeuronMocap.Tool.Tests.Files;
using static NeuronMocap.Tool.Tests.Plot.Drawing;

namespace NeuronMocap.Data.Tests.Tool;

public sealed class TakePlotTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    [Theory]
    [InlineData("MasterLiuPerformanceChar00.calc")]
    [InlineData("salsa_left_Char00.calc")]
    public async Task Calculation_exports_can_be_drawn(string name)
    {
        File.Copy(Fixtures.Require("calc", name), _folder[name]);
        XElement svg = await PlotAsync(_folder, name);
        AssertInside(svg);
        Assert.True(Points(svg, "path").Length > 10);
    }

    public void Dispose() => _folder.Dispose();
}
