using NeuronMocap.Reader;

namespace NeuronMocap.Tests.Reader;

public sealed class CombinedStatusTests
{
    [Fact]
    public void A_normal_stop_is_not_reported_as_missing_calculation()
    {
        List<ConnectionStatus> told = [];
        var joint = new CombinedStatus(told.Add, 7003);
        var receiving = new ConnectionStatus(ConnectionState.Receiving, ConnectionReason.None, "Receiving.");
        var stopped = new ConnectionStatus(ConnectionState.Stopped, ConnectionReason.Requested, "Stopped by the caller.");
        joint.OnFirst(receiving);
        joint.OnCalculation(receiving);
        joint.OnCalculation(stopped);
        joint.OnFirst(stopped);
        Assert.DoesNotContain(told, static status => status.Reason == ConnectionReason.CalculationUnavailable);
        Assert.Equal(ConnectionState.Stopped, told[^1].State);
    }
}
