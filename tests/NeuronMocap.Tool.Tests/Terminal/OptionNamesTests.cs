using System.Reflection;
using System.Reflection.Metadata;
using System.Reflection.Metadata.Ecma335;
using System.Reflection.PortableExecutable;
using System.Text.RegularExpressions;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Diagnostics;
using NeuronMocap.Recording;
using NeuronMocap.Server;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Tests.Terminal;

/// <summary>No message to a user of the command line contains the name of a library member.</summary>
public sealed partial class OptionNamesTests
{
    private static readonly Type[] OptionTypes =
    [
        typeof(NeuronReaderOptions), typeof(ReconnectPolicy), typeof(NeuronCommandOptions), typeof(DiagnosisOptions), typeof(PlaybackOptions),
        typeof(RecordingOptions), typeof(BvhExportOptions), typeof(BroadcasterOptions),
    ];

    public static TheoryData<string> ReaderOptions => [.. Settable(typeof(NeuronReaderOptions)).Where(static property => WrongValueOf(property) is not Harmless).Select(static property => property.Name)];

    public static TheoryData<string> RecordingSettings => [.. Settable(typeof(RecordingOptions)).Where(static property => WrongValueOf(property) is not Harmless).Select(static property => property.Name)];

    // The texts compiled into the libraries, so that new sentences are checked too.
    [Theory]
    [InlineData(typeof(NeuronReader))]
    [InlineData(typeof(Broadcaster))]
    public void Every_sentence_of_the_library_names_options_of_the_program(Type library)
    {
        string[] names = [.. OptionTypes.SelectMany(Settable).Select(static property => property.Name).Distinct().Where(static name => Hump().Count(name) > 1)];
        var word = new Regex($@"(?<![\w.])(?:{string.Join('|', names)})(?!\w)", RegexOptions.ExplicitCapture, TimeSpan.FromSeconds(1));
        string[] sentences = [.. TextsOf(library.Assembly).Where(text => IsSentence(text) && word.IsMatch(text))];

        Assert.NotEmpty(sentences);
        Assert.DoesNotContain(sentences.Select(OptionNames.Translate), text => word.IsMatch(text) && !IsOfDeveloper(text));
    }

    [Theory]
    [MemberData(nameof(ReaderOptions))]
    public void A_reader_option_is_reported_as_an_option_of_the_program(string name)
    {
        var options = new NeuronReaderOptions { CommandPort = 8013 };
        PropertyInfo property = typeof(NeuronReaderOptions).GetProperty(name)!;
        property.SetValue(options, WrongValueOf(property));
        AssertTranslated(Assert.ThrowsAny<ArgumentException>(() => new NeuronReader(options)), typeof(NeuronReaderOptions));
    }

    [Theory]
    [InlineData(nameof(ReconnectPolicy.InitialDelay))]
    [InlineData(nameof(ReconnectPolicy.MaxDelay))]
    public void A_reconnect_option_is_reported_as_an_option_of_the_program(string name)
    {
        var options = new NeuronReaderOptions();
        typeof(ReconnectPolicy).GetProperty(name)!.SetValue(options.Reconnect, TimeSpan.FromDays(-1));
        AssertTranslated(Assert.ThrowsAny<ArgumentException>(() => new NeuronReader(options)), typeof(NeuronReaderOptions), typeof(ReconnectPolicy));
    }

    [Theory]
    [MemberData(nameof(RecordingSettings))]
    public async Task A_recording_option_is_reported_as_an_option_of_the_program(string name)
    {
        await using var reader = new NeuronReader(new NeuronReaderOptions());
        var options = new RecordingOptions { MaxFileSize = 1 << 20 };
        PropertyInfo property = typeof(RecordingOptions).GetProperty(name)!;
        property.SetValue(options, WrongValueOf(property));
        AssertTranslated(Assert.ThrowsAny<ArgumentException>(() => reader.StartRecording("take.nmrec", options)), typeof(RecordingOptions));
    }

    private static void AssertTranslated(ArgumentException fault, params Type[] types)
    {
        string text = OptionNames.Translate(fault);
        Assert.DoesNotContain("Parameter", text, StringComparison.Ordinal);
        foreach (string name in types.SelectMany(Settable).Select(static property => property.Name))
            Assert.DoesNotMatch($@"(?<![\w-]){name}(?!\w)", text);
    }

    private static PropertyInfo[] Settable(Type type) => [.. type.GetProperties(BindingFlags.Public | BindingFlags.Instance).Where(static property => property.SetMethod is { IsPublic: true })];

    private static object? WrongValueOf(PropertyInfo property)
    {
        Type type = Nullable.GetUnderlyingType(property.PropertyType) ?? property.PropertyType;
        return type == typeof(int) ? -1
            : type == typeof(long) ? -1L
            : type == typeof(TimeSpan) ? TimeSpan.FromDays(-1)
            : type == typeof(string) ? " "
            : type == typeof(ReconnectPolicy) ? null
            : type.IsEnum ? Enum.ToObject(type, 99)
            : type == typeof(IReadOnlyList<System.Net.IPAddress>) ? new System.Net.IPAddress[1]
            : new Harmless();
    }

    private static bool IsSentence(string text) => text.Contains(' ', StringComparison.Ordinal) && !text.Contains(" = ", StringComparison.Ordinal);

    // Texts that only another program can cause: data other than motion, and the settings of its own server.
    private static bool IsOfDeveloper(string text) => text.Contains("StudioCalculation", StringComparison.Ordinal)
        || text.StartsWith("must ", StringComparison.Ordinal) || text.StartsWith("needs ", StringComparison.Ordinal) || text.StartsWith("may be ", StringComparison.Ordinal);

    private static List<string> TextsOf(Assembly assembly)
    {
        var texts = new List<string>();
        using var image = new PEReader(File.OpenRead(assembly.Location));
        MetadataReader reader = image.GetMetadataReader();
        for (UserStringHandle handle = MetadataTokens.UserStringHandle(1); !handle.IsNil; handle = reader.GetNextHandle(handle))
            texts.Add(reader.GetUserString(handle));

        return texts;
    }

    [GeneratedRegex("[A-Z][a-z]+", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Hump();

    private sealed record Harmless;
}
