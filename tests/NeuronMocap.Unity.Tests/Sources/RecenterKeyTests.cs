using NeuronMocap.Unity.InputSystem;
using NeuronMocap.Unity.Tests.Infrastructure;
using UnityEngine.InputSystem;

namespace NeuronMocap.Unity.Tests.Sources;

/// <summary>The key that recentres, with the old Input Manager and with the Input System.</summary>
public sealed class RecenterKeyTests : SourceFixture
{
    public override void Dispose()
    {
        Keyboard.current = null;
        base.Dispose();
        GC.SuppressFinalize(this);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_key_recentres(bool isInputSystem)
    {
        if (isInputSystem)
            Keyboard.current = new Keyboard();

        var actor = new PlacedActor();
        actor.Put(new Vector3(1, 0, 2), 30);
        MocapSource source = Add(Serve(actor), static source => source.Resample = false);
        Performer performer = WaitForPose(source);

        // Not assigned yet.
        Press(isInputSystem);
        Assert.True(performer.GetPosition(Bone.Hips).z > 1.9f);
        Input.Release(KeyCode.R);

        source.RecenterKey = KeyCode.R;
        Loop.Frame();
        Assert.True(performer.GetPosition(Bone.Hips).z > 1.9f);
        Press(isInputSystem);

        Vector3 hips = performer.GetPosition(Bone.Hips);
        Assert.True(new Vector2(hips.x, hips.z).magnitude < 2e-3f, $"{hips}");
    }

    [Fact]
    public void Every_key_of_a_keyboard_is_the_key_of_its_name()
    {
        (string Old, string New)[] renamed =
        [
            ("Return", "Enter"), ("Alpha", "Digit"), ("Keypad", "Numpad"), ("BackQuote", "Backquote"), ("Control", "Ctrl"), ("Numlock", "NumLock"),
            ("Print", "PrintScreen"), ("Menu", "ContextMenu"),
        ];
        foreach (KeyCode code in Enum.GetValues<KeyCode>().Where(static code => code is > KeyCode.None and < KeyCode.Mouse0))
        {
            string name = renamed.Aggregate($"{code}", static (name, pair) => name.Replace(pair.Old, pair.New, StringComparison.Ordinal));
            Assert.Equal(name, $"{InputSystemKeys.KeyOf(code)}");
        }

        Assert.Equal(Key.None, InputSystemKeys.KeyOf(KeyCode.Mouse0));
    }

    private void Press(bool isInputSystem)
    {
        if (isInputSystem)
            Keyboard.current!.Press(Key.R);
        else
            Input.Press(KeyCode.R);

        Loop.Frame();
    }
}
