using System.Drawing;
using System.Windows.Forms;

// The sizes are pixels at 96 dpi. WinForms scales them to the resolution of the screen.
internal sealed partial class MainWindow
{
    private static readonly Color Field = Color.FromArgb(20, 22, 27);
    private static readonly Color Light = Color.FromArgb(232, 234, 238);

    private readonly TextBox _address = new() { Dock = DockStyle.Fill, BackColor = Field, ForeColor = Light, BorderStyle = BorderStyle.FixedSingle };
    private readonly Button _connect = CreateButton("Connect");
    private readonly Button _record = CreateButton("Record");
    private readonly Label _status = CreateLabel(DockStyle.Top, height: 44); // for two lines
    private readonly Label _rates = CreateLabel(DockStyle.Bottom, height: 28);
    private readonly Label _recording = CreateLabel(DockStyle.Bottom, height: 28);
    private readonly ListBox _list = new() { Dock = DockStyle.Left, Width = 230, BackColor = Field, ForeColor = Light, BorderStyle = BorderStyle.None };
    private readonly SkeletonView _skeleton = new() { Dock = DockStyle.Fill, BackColor = Field };
    private readonly Timer _timer = new() { Interval = 250 };

    private void CreateControls()
    {
        Text = "Motion";
        Font = SystemFonts.MessageBoxFont;
        (BackColor, ForeColor, Padding) = (Color.FromArgb(30, 33, 39), Light, new Padding(8));
        AcceptButton = _connect;
        _list.IntegralHeight = false;

        var bar = new TableLayoutPanel { Dock = DockStyle.Top, AutoSize = true, ColumnCount = 4, RowCount = 1 };
        bar.ColumnStyles.Add(new ColumnStyle(SizeType.AutoSize));
        bar.ColumnStyles.Add(new ColumnStyle(SizeType.Percent, 100));
        bar.Controls.AddRange([new Label { Text = "Address", AutoSize = true, Anchor = AnchorStyles.Left }, _address, _connect, _record]);

        // The last control takes its edge first, and the first one fills what is left.
        Controls.AddRange([_skeleton, _list, _rates, _recording, _status, bar]);
        AutoScaleDimensions = new SizeF(96, 96);
        AutoScaleMode = AutoScaleMode.Dpi;
        (ClientSize, ActiveControl) = (new Size(900, 560), _address);
    }

    private static Label CreateLabel(DockStyle dock, int height) =>
        new() { Dock = dock, Height = height, UseMnemonic = false, TextAlign = ContentAlignment.MiddleLeft };

    private static Button CreateButton(string text) =>
        new() { Text = text, AutoSize = true, FlatStyle = FlatStyle.Flat, BackColor = Field, ForeColor = Light };
}
