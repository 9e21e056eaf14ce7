using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Grammar;

/// <summary>Selects the grammar that changes an input.</summary>
internal sealed class Grammars
{
    private readonly BvhGrammar _bvh = new();
    private readonly CalculationGrammar _calculation = new();
    private readonly RecordingGrammar _recording = new();

    /// <summary>Returns null if the input has no known structure.</summary>
    public IGrammar? Of(CorpusKind kind, ReadOnlySpan<byte> input) => kind switch
    {
        CorpusKind.Bvh => _bvh,
        CorpusKind.Calculation => _calculation,
        CorpusKind.Text => _calculation,
        CorpusKind.Recordings => _recording,
        CorpusKind.Files when Recording.RecordingReader.IsRecording(input) => _recording,
        CorpusKind.Files when input.IndexOf("OFFSET"u8) >= 0 => _bvh,
        CorpusKind.Files when input.IndexOf((byte)0) < 0 => _calculation,
        _ => null,
    };
}
