using System.Text;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests;

public sealed class CommandLineTests
{
    public static TheoryData<string> Verbs { get; } = ["watch", "view", "diagnose", "simulate", "relay", "play", "info", "convert", "plot", "command", "completion"];

    [Theory]
    [InlineData("--frames", "watch", "--frames", "0")]
    [InlineData("--frames", "watch", "--frames", "-1")]
    [InlineData("--frames", "watch", "--frames", "1.5")]
    [InlineData("--frames needs a value, N.", "watch", "--frames")]
    [InlineData("--rate needs a value, HZ.", "info", "--rate=", "box.bvh")]
    [InlineData("--from needs a value, SECONDS.", "convert", "--from=", "in.bvh", "out.bvh")]
    [InlineData("--from needs a value, SECONDS.", "convert", "in.bvh", "out.bvh", "--from:")]
    [InlineData("--from needs a value, SECONDS.", "convert", "--from=", "--to=", "in.bvh", "out.bvh")]
    [InlineData("--record needs a value, FILE.", "watch", "demo", "--duration", "1", "--record=", "o/eq.nmrec")]
    [InlineData("--token needs a value, WORD.", "view", "demo", "--token=", "foo")]
    [InlineData("--commands needs a value, PORT.", "simulate", "--commands=", "8013")]
    [InlineData("--json takes no value.", "info", "--json=", "a.bvh")]
    [InlineData("--frames is given more than once.", "watch", "--frames", "1", "--frames", "2")]
    [InlineData("--duration", "watch", "--duration", "0")]
    [InlineData("--duration", "watch", "--duration", "NaN")]
    [InlineData("--duration", "watch", "--duration", "1,5")]
    [InlineData("--duration", "watch", "--duration", "1000001")]
    [InlineData("--order", "watch", "--order", "XXY")]
    [InlineData("--order", "watch", "--order", "1")]
    [InlineData("--quiet", "watch", "--json", "--quiet")]
    [InlineData("--quiet", "relay", "demo", "tcp://:7001", "--json", "--quiet")]
    [InlineData("'port' in 'studio:port' is not a port", "watch", "studio:port")]
    [InlineData("'b'", "watch", "studio", "b")]
    [InlineData("--colour", "watch", "--colour")]
    [InlineData("--allow-sender", "watch", "udp://:7001", "--allow-sender", "studio")]
    [InlineData("--allow-sender", "watch", "udp://:7001", "--allow-sender")]
    [InlineData("udp://:PORT", "watch", "studio", "--allow-sender", "127.0.0.1")]
    [InlineData("udp://:PORT", "watch", "--allow-sender", "127.0.0.1")]
    [InlineData("--command-port", "watch", "studio", "--command-port", "0")]
    [InlineData("--command-port needs a source HOST", "watch", "--command-port", "8013")]
    [InlineData("--command-port needs a source HOST", "watch", "udp://:7001", "--command-port", "8013")]
    [InlineData("--command-port", "watch", "studio:8013", "--command-port", "8013")]
    [InlineData("--local-address", "watch", "udp://127.0.0.1:7001", "--local-address", "127.0.0.1")]
    [InlineData("--local-address", "watch", "--local-address", "127.0.0.1")]
    [InlineData("--local-address", "watch", "studio", "--local-address", "office")]
    [InlineData("--calculation-port", "watch", "studio", "--calculation-port", "0")]
    [InlineData("--calculation-port", "watch", "--calculation-port", "7003")]
    [InlineData("--calculation-port", "watch", "take.nmrec", "--calculation-port", "7003")]
    [InlineData("udp://", "watch", "udp://studio")]
    [InlineData("'udp://:0' has no port", "watch", "udp://:0")]
    [InlineData("http://studio", "watch", "http://studio")]
    [InlineData("--record", "watch", "--record")]
    [InlineData("--record", "watch", "--record", " ")]
    [InlineData("--record needs a value, and --quiet is another option.", "watch", "--record", "--quiet")]
    [InlineData("--record needs a value, and --help is another option.", "watch", "--record", "--help")]
    [InlineData("--record needs a value, and --qiet looks like another option. Write ./--qiet", "watch", "--record", "--qiet")]
    [InlineData("--bvh needs a value, and --local-address is another option.", "simulate", "--bvh", "--local-address", "127.0.0.1")]
    [InlineData("unknown option --local-adress: did you mean --local-address?", "simulate", "--local-adress", "127.0.0.1")]
    [InlineData("--local-address: 'x' is not an IP address.", "simulate", "--local-address", "x")]
    [InlineData("--json takes no value.", "watch", "--json=1", "demo")]
    [InlineData("--json takes no value.", "watch", "--json=1")]
    [InlineData("--json takes no value.", "info", "a.bvh", "--json:true")]
    [InlineData("there is no file 'take.bhv'", "watch", "take.bhv")]
    [InlineData("did you mean .calc? For a computer of that name, write tcp://take.clac.", "diagnose", "take.clac")]
    [InlineData("did you mean .nmrec?", "command", "take.nmrce")]
    [InlineData("Use HOST, HOST:PORT, tcp://HOST:PORT, tls://HOST:PORT, ws://HOST:PORT, udp://:PORT, or demo.", "diagnose", "ftp://studio")]
    [InlineData("Use HOST, HOST:PORT, tcp://HOST:PORT or demo.", "command", "ftp://studio")]
    [InlineData("--avatar is not for order", "command", "demo", "order", "--avatar", "3")]
    [InlineData("--local-address needs a server", "command", "demo", "--local-address", "127.0.0.1")]
    [InlineData("--local-address", "command", "studio", "--local-address", "here")]
    [InlineData("--avatar is not for order", "command", "demo", "--avatar", "3", "ORDER")]
    [InlineData("--loop needs --bvh, --calc or --play", "simulate", "--loop")]
    [InlineData("--data-commands needs a TCP port", "simulate", "--udp", "127.0.0.1:7002", "--data-commands", "on")]
    [InlineData("--motion off and --reference exclude each other", "simulate", "--motion", "off", "--reference", "on")]
    [InlineData("'--frames' is one argument too many.", "watch", "--", "demo", "--frames")]
    [InlineData("--rate max sends as fast as clients read.", "simulate", "--play", "a.nmrec", "--speed", "max")]
    [InlineData("--export: the name of the file is empty.", "watch", "--export", " ")]
    [InlineData("--record", "watch", "--record-compress")]
    [InlineData("--record-size", "watch", "--record", "take", "--record-size", "1")]
    [InlineData("--record-time", "watch", "--record", "take", "--record-time", "0")]
    [InlineData("--record-files", "watch", "--record", "take", "--record-files", "3")]
    [InlineData("take.bvh", "watch", "--record", "take.bvh")]
    [InlineData(".nmrec", "watch", "--record", "take.bvh")]
    [InlineData("take.fbx", "watch", "--export", "take.fbx")]
    [InlineData(".bvh", "watch", "--export", "take.fbx")]
    [InlineData("--overwrite", "watch", "--overwrite")]
    [InlineData("relay needs SOURCE.", "relay")]
    [InlineData("relay needs TO.", "relay", "studio")]
    [InlineData("'ftp://:7001' is not a destination. Use tcp://[ADDRESS]:PORT, ws://[ADDRESS]:PORT, udp://HOST:PORT, ", "relay", "studio", "ftp://:7001")]
    [InlineData("'amqps://...@broker' is not a destination.", "relay", "studio", "amqps://me:secret@broker")]
    [InlineData("'amqps://...@broker' is not a source.", "watch", "amqps://me:secret@broker")]
    [InlineData("'amqp://...@broker:x' is not the address of a broker.", "watch", "amqp://me:secret@broker:x")]
    [InlineData("'amqp://...@broker?size=1' has an unknown part 'size'.", "relay", "studio", "amqp://me:secret@broker?size=1")]
    [InlineData("'from' needs a stream", "watch", "amqp://broker?from=first")]
    [InlineData("amqp://broker:5672/?stage=main would send the source amqp://broker:5672/?stage=main to itself. Choose another stage.", "relay", "amqp://a:secret@broker", "amqp://b:secret@broker:5672/?stage=main")]
    [InlineData("amqp://broker:5672/?stage=x and amqp://broker:5672/?stage=x are the same destination.", "relay", "studio", "amqp://broker?stage=x", "amqp://me:secret@broker?stage=x")]
    [InlineData("is a broker, which has no steps to diagnose", "diagnose", "amqp://me:secret@broker")]
    [InlineData("'tcp://' has no port to listen on", "relay", "studio", "tcp://")]
    [InlineData("'office' in 'tcp://office:7001' is not an address", "relay", "studio", "tcp://office:7001")]
    [InlineData("'udp://:7012' names no computer", "relay", "studio", "udp://:7012")]
    [InlineData("a.nmrec and ./a.nmrec are the same destination.", "relay", "studio", "a.nmrec", "./a.nmrec")]
    [InlineData("tcp://:7001 and tcp://127.0.0.1:7001 are the same destination.", "relay", "studio", "tcp://:7001", "tcp://127.0.0.1:7001")]
    [InlineData("would send the source tcp://localhost:7001 to itself", "relay", "localhost", "tcp://:7001")]
    [InlineData("would send the source udp://:7012 to itself", "relay", "udp://:7012", "udp://127.0.0.1:7012")]
    [InlineData("would send the source a.nmrec to itself", "relay", "a.nmrec", "./a.nmrec")]
    [InlineData("--commands needs a source HOST", "relay", "demo", "tcp://:0", "--commands", "tcp://:8013")]
    [InlineData("--commands and tcp://:8013 need different ports.", "relay", "studio", "tcp://:8013", "--commands", "tcp://127.0.0.1:8013")]
    [InlineData("--commands: 'udp://a:1' is not a place to listen", "relay", "studio", "tcp://:0", "--commands", "udp://a:1")]
    [InlineData("--speed max", "relay", "a.nmrec", "tcp://:0", "--speed", "max")]
    [InlineData("--speed needs a file as the source", "relay", "demo", "tcp://:0", "--speed", "2")]
    [InlineData("--once is for a connection", "relay", "a.nmrec", "tcp://:0", "--once")]
    [InlineData("--overwrite needs a file", "relay", "demo", "tcp://:0", "--overwrite")]
    [InlineData("HOST[:PORT]", "command")]
    [InlineData("'port' in 'studio:port' is not a port", "command", "studio:port")]
    [InlineData("udp://:8013", "command", "udp://:8013")]
    [InlineData("take.nmrec", "command", "take.nmrec", "order")]
    [InlineData("did you mean header?", "command", "studio", "headr")]
    [InlineData("order, bones, header, zero-out", "command", "studio", "sizes")]
    [InlineData("--avatar", "command", "studio", "--avatar", "-1")]
    [InlineData("--quiet", "command", "studio", "--quiet")]
    [InlineData(".calc (calculation export)", "convert", "a.bvh", "b.fbx")]
    [InlineData("convert needs OUT.", "convert", "a.bvh")]
    [InlineData("--from", "convert", "a.bvh", "b.bvh", "--from", "3", "--to", "3")]
    [InlineData(".svg", "plot", "a.bvh", "b.png")]
    [InlineData("--resample", "plot", "a.bvh", "b.svg", "--resample", "60")]
    [InlineData("--overwrite", "info", "a.bvh", "--overwrite")]
    [InlineData("info needs FILE.", "info", "--json")]
    [InlineData("play needs FILE.", "play")]
    [InlineData("'ksh'", "completion", "ksh")]
    [InlineData("--udp: 'studio' is not of the form HOST:PORT.", "simulate", "--udp", "studio")]
    [InlineData("--udp: '::1' is not of the form HOST:PORT.", "simulate", "--udp", "::1")]
    [InlineData("--udp: '70000' in 'studio:70000' is not a port.", "simulate", "--udp", "localhost:7002", "--udp", "studio:70000")]
    [InlineData("--server: 'udp://:7003' is a port of this computer.", "diagnose", "udp://:7002", "--server", "udp://:7003")]
    public async Task A_wrong_option_is_one_line_that_says_where_help_is_and_ends_with_2(string named, string verb, params string[] args)
    {
        ToolResult result = await ToolRunner.RunAsync([verb, .. args]);

        Assert.Equal(2, result.ExitCode);
        Assert.Empty(result.Output);
        string line = Assert.Single(result.Error);
        Assert.StartsWith("neuron-mocap: ", line, StringComparison.Ordinal);
        Assert.Contains(named, line, StringComparison.Ordinal);
        Assert.EndsWith($" neuron-mocap {verb} --help lists the options.", line, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--recrod", "--record")]
    [InlineData("--RECORD", "--record")]
    [InlineData("-record", "--record")]
    [InlineData("--duratio", "--duration")]
    [InlineData("--durtaion=5", "--duration")]
    [InlineData("--allow-senders", "--allow-sender")]
    [InlineData("--rec", "--record")]
    [InlineData("--colour", null)]
    [InlineData("--", null)]
    [InlineData("-x", null)]
    public async Task An_unknown_option_is_named_with_a_suggestion(string typed, string? meant)
    {
        ToolResult result = await ToolRunner.RunAsync("watch", "studio", typed, "value");

        Assert.Equal(2, result.ExitCode);
        string line = Assert.Single(result.Error);
        if (meant is not null)
            Assert.Contains($"unknown option {typed}: did you mean {meant}? ", line, StringComparison.Ordinal);
        else
            Assert.DoesNotContain("did you mean", line, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("unknown verb 'wach': did you mean watch?", "wach")]
    [InlineData("unknown verb 'wacth': did you mean watch?", "wacth")]
    [InlineData("unknown verb 'Watch': did you mean watch?", "Watch", "demo")]
    [InlineData("unknown verb 'help': did you mean --help?", "help")]
    [InlineData("unknown verb 'help': did you mean neuron-mocap watch --help?", "help", "watch")]
    [InlineData("unknown verb '/?': did you mean --help?", "/?")]
    [InlineData("unknown option -?: did you mean --help?", "-?")]
    [InlineData("unknown option -V: did you mean --version?", "-V")]
    [InlineData("unknown verb '192.168.1.20': did you mean neuron-mocap watch 192.168.1.20?", "192.168.1.20", "--json")]
    [InlineData("unknown verb 'demo': did you mean neuron-mocap watch demo?", "demo")]
    [InlineData("unknown verb 'frobnicate'.", "frobnicate", "--help")]
    [InlineData("unknown option --json: did you mean neuron-mocap watch --json?", "--json")]
    [InlineData("unknown option --resample: did you mean neuron-mocap convert --resample?", "--resample", "60")]
    [InlineData("unknown option --info: did you mean neuron-mocap info?", "--info", "take.bvh")]
    [InlineData("unknown option --frobnicate.", "--frobnicate")]
    public async Task An_unknown_verb_is_named_with_a_suggestion(string said, params string[] args)
    {
        ToolResult result = await ToolRunner.RunAsync(args);

        Assert.Equal(2, result.ExitCode);
        Assert.Empty(result.Output);
        Assert.Equal($"neuron-mocap: {said} neuron-mocap --help lists the verbs.", Assert.Single(result.Error));
    }

    [Fact]
    public async Task A_file_whose_name_begins_with_a_dash_follows_two_dashes()
    {
        ToolResult result = await ToolRunner.RunAsync("play", "--", "-missing.nmrec");
        Assert.Equal((1, "neuron-mocap: '-missing.nmrec' does not exist."), (result.ExitCode, Assert.Single(result.Error)));
    }

    [Fact]
    public async Task A_word_before_the_verb_is_explained()
    {
        ToolResult result = await ToolRunner.RunAsync("studio", "watch");
        Assert.Equal((2, "neuron-mocap: 'studio' is before the verb watch. neuron-mocap watch --help lists the options."), (result.ExitCode, Assert.Single(result.Error)));
    }

    [Fact]
    public async Task An_option_before_the_verb_is_explained()
    {
        ToolResult result = await ToolRunner.RunAsync("--json", "watch", "demo");

        Assert.Equal(2, result.ExitCode);
        Assert.Contains("write neuron-mocap watch --json.", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    // Covers every option that --help lists, so that new options are tested too. An option without values has another sentence.
    [Theory]
    [MemberData(nameof(Verbs))]
    public async Task An_empty_value_never_takes_the_next_word(string verb)
    {
        foreach (VerbOption option in await VerbHelp.ReadAsync(verb))
        {
            foreach (string separator in (string[])["=", ":"])
            {
                ToolResult result = await ToolRunner.RunAsync([verb, option.Name + separator, .. VerbHelp.FilesOf(verb)]);
                Assert.Equal(2, result.ExitCode);
                Assert.Matches($"^neuron-mocap: {option.Name} (needs a value, |takes no value)", Assert.Single(result.Error));
            }
        }
    }

    [Fact]
    public async Task After_two_dashes_a_name_may_end_with_an_equals_sign()
    {
        ToolResult result = await ToolRunner.RunAsync("info", "--", "--rate=");
        Assert.Equal((1, "neuron-mocap: '--rate=' does not exist."), (result.ExitCode, Assert.Single(result.Error)));
    }

    // Covers every option that --help lists, so that new options are tested too: with a value that none accepts, and without a value.
    [Theory]
    [MemberData(nameof(Verbs))]
    public async Task Every_error_names_its_option(string verb)
    {
        foreach (VerbOption option in await VerbHelp.ReadAsync(verb))
        {
            // A file or a host may have any name.
            string[][] wrong = option.MayStandAlone ? [[option.Name, "a:b:c"]] : [[option.Name, "a:b:c", option.Name, "a:b:c"], [option.Name]];
            foreach (string[] args in wrong)
            {
                ToolResult result = await ToolRunner.RunAsync([verb, .. VerbHelp.FilesOf(verb), .. args]);
                Assert.Equal(2, result.ExitCode);
                string line = Assert.Single(result.Error);
                Assert.Contains(option.Name, line, StringComparison.Ordinal);
                Assert.DoesNotMatch("(?-i)[a-z][A-Z]", line);
            }
        }
    }

    [Fact]
    public async Task A_word_that_names_a_file_is_a_file()
    {
        string path = Path.GetTempFileName();
        try
        {
            ToolResult result = await ToolRunner.RunAsync("watch", path);
            Assert.Equal(1, result.ExitCode);
            Assert.Equal($"neuron-mocap: '{path}' is empty.", Assert.Single(result.Error));
        }
        finally
        {
            File.Delete(path);
        }
    }

    // The first line can come between the first frame's status and its count.
    [Fact]
    public async Task The_program_alone_is_watch_demo()
    {
        const string Performer = " 0 Demo motion ";
        using var stop = new CancellationTokenSource(TimeSpan.FromMinutes(1));
        using var output = new StoppingStream(Performer, stop);
        using var error = new StringWriter();
        using var streams = new StandardStreams(output, error, IsTerminal: false);

        Assert.Equal(0, await CommandLine.RunAsync([], streams, stop.Token));
        Assert.Contains(Performer, output.Text, StringComparison.Ordinal);
    }

    // Stops the program when it has written a word.
    private sealed class StoppingStream(string word, CancellationTokenSource stop) : MemoryStream
    {
        public string Text => Encoding.UTF8.GetString(ToArray());

        public override void Write(ReadOnlySpan<byte> buffer)
        {
            base.Write(buffer);
            if (Text.Contains(word, StringComparison.Ordinal))
                stop.Cancel();
        }
    }
}
