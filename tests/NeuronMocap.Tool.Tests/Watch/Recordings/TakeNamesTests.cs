using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.Tests.Watch.Recordings;

public sealed class TakeNamesTests
{
    private static readonly DateTime Now = new(2026, 2, 3, 14, 5, 6, DateTimeKind.Local);

    [Fact]
    public void A_missing_name_becomes_date_and_time() => Assert.Equal(
        ["neuron-2026-02-03-140506.nmrec", "neuron-2026-02-03-140506-2.nmrec", "neuron-2026-02-03-140506-3.nmrec"],
        TakeNames.After(path: null, Now).Take(3),
        StringComparer.Ordinal);

    [Theory]
    [InlineData("takes.d/walk.nmrec", "takes.d/walk-2.nmrec")]
    [InlineData("takes.d/walk", "takes.d/walk-2")]
    public void The_name_of_record_gets_a_number(string path, string second) =>
        Assert.Equal([path, second], TakeNames.After(path, Now).Take(2), StringComparer.Ordinal);
}
