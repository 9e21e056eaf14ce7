using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>The reader's messages about unknown bytes. For each reason there is a sentence that any terminal can show.</summary>
internal static class GuessTarget
{
    private const int Looks = 32;

    // The number of bytes that a reader keeps.
    private const int Kept = 64;

    private static readonly SkipReason[] Reasons = Enum.GetValues<SkipReason>();

    public static void Run(FuzzInput input)
    {
        for (int i = 0; i < Looks; i++)
        {
            ReadOnlySpan<byte> start = input.Bytes[(i == 0 ? 0 : input.Random.Below(input.Bytes.Length + 1))..];
            start = start[..Math.Min(start.Length, input.Random.Below(4) == 0 ? input.Random.Below(Kept + 1) : Kept)];
            var guess = FormatGuess.Of(start, input.Random.Choose(Reasons));
            WrongResultException.ThrowUnless(guess.Text.Length > 0 && guess.Advice.Length > 0, "Nothing is said.");
            foreach (char letter in guess.Description)
                WrongResultException.ThrowUnless(!char.IsControl(letter), "A control character is said.");

            input.Digest.Add(guess.Description);
            input.Found += guess.Format == ForeignFormat.Unknown ? 0 : 1;
        }
    }
}
