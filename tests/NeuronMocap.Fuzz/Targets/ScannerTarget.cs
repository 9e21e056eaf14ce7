using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>Scans the whole input in one piece, and its tails, with different limits.</summary>
internal sealed class ScannerTarget
{
    private const int Tails = 16;

    private readonly (PacketScanner Scanner, int MaxValues)[] _scanners =
        [(new(), ProtocolConstants.DefaultMaxValues), (new(1), 1), (new(360), 360), (new(1_000_000), 1_000_000)];

    public void Run(FuzzInput input)
    {
        foreach ((PacketScanner scanner, int maxValues) in _scanners)
        {
            int longest = ProtocolConstants.HeaderSize + Math.Max(maxValues * sizeof(float), ProtocolConstants.MaxCommandPayload);
            ReadOnlySpan<byte> rest = input.Bytes;
            while (Scan(scanner, rest, longest, input) is { Status: not ScanStatus.NeedMoreData } result)
                rest = rest[result.Length..];

            for (int i = 0; i < Tails; i++)
            {
                ReadOnlySpan<byte> tail = input.Bytes[input.Random.Below(input.Bytes.Length + 1)..];
                Scan(scanner, tail[..input.Random.Below(tail.Length + 1)], longest, input);
            }
        }
    }

    private static ScanResult Scan(PacketScanner scanner, ReadOnlySpan<byte> bytes, int longest, FuzzInput input)
    {
        ScanResult result = scanner.Scan(bytes);
        WrongResultException.ThrowUnless(result.Length > 0, "An answer of length zero does not advance.");
        WrongResultException.ThrowUnless(
            result.Status == ScanStatus.NeedMoreData ? result.Length > bytes.Length : result.Length <= bytes.Length,
            "{0} is not an answer to {1} bytes.", result, bytes.Length);
        WrongResultException.ThrowUnless(
            result.Status == ScanStatus.Skipped || result.Length <= longest, "{0} is longer than the limits allow.", result);
        WrongResultException.ThrowUnless(
            (result.Status == ScanStatus.Packet) == (result.Kind != PacketKind.None), "{0} contradicts itself.", result);
        input.Digest.Add((long)result.Status);
        input.Digest.Add((long)result.Length);
        input.Digest.Add((long)result.Kind);
        input.Digest.Add((long)result.Reason);
        input.Found += result.Status == ScanStatus.Packet ? 1 : 0;
        return result;
    }
}
