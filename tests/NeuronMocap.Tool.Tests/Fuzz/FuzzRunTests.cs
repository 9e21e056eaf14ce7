using NeuronMocap.Fuzz;
using NeuronMocap.Fuzz.Grammar;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Fuzz.Running;
using NeuronMocap.Fuzz.Targets;

namespace NeuronMocap.Tool.Tests.Fuzz;

/// <summary>The fuzzing program finds faults, and only faults.</summary>
public sealed class FuzzRunTests
{
    private const long Bytes = 2_500_000;

    [Theory]
    [InlineData("exception", "IndexOutOfRangeException")]
    [InlineData("another exception than the refusal", "InvalidDataException")]
    [InlineData("wrong result", "wrong result")]
    [InlineData("allocation", "allocation")]
    [InlineData("a read behind the end", "surroundings")]
    [InlineData("a read before the start", "surroundings")]
    [InlineData("a write to the input", "written")]
    [InlineData("a write behind the end", "written")]
    public void A_planted_fault_is_found_and_its_input_minimized(string fault, string kind)
    {
        FuzzRun run = Run(PlantedFaults.Get(fault), PlantedFaults.Get("none"));

        FailingInput failing = Assert.Single(run.Progress[0].FailingInputs);
        Assert.Equal((fault, kind), (failing.Target, failing.Failure.Kind));
        Assert.Equal(PlantedFaults.Trigger, failing.Smallest);
        Assert.Empty(run.Progress[1].FailingInputs);
        Assert.InRange(run.Progress[1].Bytes, Bytes / 2, Bytes);
    }

    [Theory]
    [InlineData("none")]
    [InlineData("refusal")]
    public void A_correct_parser_has_no_findings(string name) =>
        Assert.Empty(Run(PlantedFaults.Get(name)).Progress[0].FailingInputs);

    [Fact]
    public void A_hanging_input_ends_the_run_and_is_kept()
    {
        using var end = new ManualResetEventSlim();
        FuzzRun run = Run(PlantedFaults.Hang(end));
        end.Set();

        FailingInput failing = Assert.Single(run.Progress[0].FailingInputs);
        Assert.Equal("hang", failing.Failure.Kind);
        Assert.True(failing.Original.AsSpan().IndexOf(PlantedFaults.Trigger) >= 0);
    }

    [Fact]
    public void An_endlessly_writing_input_ends_the_run_and_is_kept()
    {
        using var end = new ManualResetEventSlim();
        FuzzRun run = Run(PlantedFaults.Hang(end) with { TimeLimit = TimeSpan.FromHours(1), CountOutput = () => 100, OutputPerInput = 99 });
        end.Set();

        Assert.Equal("output", Assert.Single(run.Progress[0].FailingInputs).Failure.Kind);
        Assert.True(run.IsCutShort);
    }

    [Fact]
    public void Two_faults_of_one_parser_are_reported_separately()
    {
        FuzzRun run = Run(PlantedFaults.Get("two exceptions"));
        Assert.Equal(["FormatException", "InvalidDataException"], run.Progress[0].FailingInputs.Select(static failing => failing.Failure.Kind).Order(StringComparer.Ordinal));
        Assert.True(run.Progress[0].Failures > 2, "The run ended with the second failure.");
    }

    // Known faults of the library or a tool stay fixed.
    [Fact]
    public void Every_kept_input_is_read_by_every_target()
    {
        Assert.NotEmpty(KeptInputs.All);
        foreach (FuzzTarget target in TargetList.All)
        {
            var runner = new InputRunner(target);
            foreach ((string name, byte[] bytes) in KeptInputs.All)
                Assert.True(runner.Run(bytes, isThorough: true) is null, $"{target.Name} fails with {name}.");
        }
    }

    [Theory]
    [InlineData(nameof(CorpusKind.Bvh))]
    [InlineData(nameof(CorpusKind.Calculation))]
    [InlineData(nameof(CorpusKind.Recordings))]
    public void Parts_of_a_file_are_swapped_repeated_and_removed(string name)
    {
        CorpusKind kind = Enum.Parse<CorpusKind>(name);
        byte[] fixture = Corpus.Load(kind, data: null).Fixtures[0];
        var grammar = new Grammars();
        var lengths = new List<int>();
        bool hasSwapped = false;
        for (ulong seed = 0; seed < 500; seed++)
        {
            var buffer = new InputBuffer();
            buffer.Append(fixture);
            var random = new FuzzRandom(seed);
            new GrammarMutator(buffer).Change(grammar.Of(kind, fixture)!, ref random);
            lengths.Add(buffer.Length);
            hasSwapped |= buffer.Length == fixture.Length && !buffer.Bytes.SequenceEqual(fixture);
        }

        Assert.True(hasSwapped, "Nothing was swapped.");
        Assert.Contains(lengths, length => length < fixture.Length);
        Assert.Contains(lengths, length => length > fixture.Length);
    }

    [Fact]
    public void A_seed_gives_the_same_inputs_to_one_or_all_targets()
    {
        List<ulong> first = Inputs(seed: 1, others: []);
        Assert.Equal(first, Inputs(seed: 1, others: [PlantedFaults.Get("none")]));
        Assert.NotEqual(first, Inputs(seed: 2, others: []));
        Assert.True(first.Distinct().Count() > first.Count * 9 / 10, "Most inputs are copies of others.");
    }

    // The first fixtures are passed on unchanged, so each target must recognise something at once.
    [Fact]
    public void Every_target_of_the_program_is_clean_and_recognises_something()
    {
        FuzzRun run = Run([.. TargetList.All]);
        Assert.All(run.Progress, target => Assert.Empty(target.FailingInputs));
        Assert.All(run.Progress, target => Assert.True(target.Runner.Found > 5, $"{target.Target.Name} found {target.Runner.Found}."));
    }

    private static FuzzRun Run(params FuzzTarget[] targets)
    {
        var run = new FuzzRun(targets, Bytes, seed: 1, data: null, TestContext.Current.CancellationToken);
        run.Run(() => { });
        return run;
    }

    private static List<ulong> Inputs(ulong seed, FuzzTarget[] others)
    {
        List<ulong> seen = [];
        var recorder = new FuzzTarget("recorder", CorpusKind.Packets, () => Record) { AllocatedPerInput = 1 << 20 };
        new FuzzRun([recorder, .. others], Bytes * (1 + others.Length), seed, data: null, TestContext.Current.CancellationToken).Run(() => { });
        return seen;

        // Some inputs are read twice.
        void Record(FuzzInput input)
        {
            ulong digest = Digest.Of(input.Bytes);
            if (seen.Count == 0 || seen[^1] != digest)
                seen.Add(digest);
        }
    }
}
