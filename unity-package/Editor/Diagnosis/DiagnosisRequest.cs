#nullable enable

using System.Net;

namespace NeuronMocap.Unity.EditorTools
{
    internal static class DiagnosisRequest
    {
        // The options that the source's own reader would have.
        public static NeuronReaderOptions OptionsOf(MocapSource source) => new NeuronReaderOptions
        {
            Transport = source.Transport,
            Host = source.Transport == TransportKind.Udp && source.Address.Trim().Length == 0 ? "127.0.0.1" : source.Address.Trim(),
            Port = source.Port,
            LocalAddress = IPAddress.TryParse(source.LocalAddress.Trim(), out IPAddress? address) ? address : null,
            CalculationPort = source.CalculationPort > 0 ? source.CalculationPort : (int?)null,
            CommandPort = source.CommandPort > 0 ? source.CommandPort : (int?)null,
            RotationOrder = source.RotationOrder.ToOrder(),
            SkeletonVariant = source.SkeletonVariant.ToVariant(),
        };
    }
}
