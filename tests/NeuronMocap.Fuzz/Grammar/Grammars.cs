using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Grammar;

/// <summary>Which grammar an input is changed by.</summary>
internal sealed class Grammars
{
    private readonly BvhGrammar _bvh = new();
    private readonly CalculationGrammar _calculation = new();
    private readonly RecordingGrammar _recording = new();

    /// <summary>Null where bytes are all that is known.</summary>
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
