import type { Connection } from "../live/connection";
import type { Status } from "../live/messages";
import type { Page, Takes } from "../page/page";
import type { SettingsStore } from "../page/settings";
import type { Views } from "../scene/views";
import { createDiagnosisButton } from "./diagnosis";
import { Header } from "./header";
import { Hud } from "./hud";
import { Overlay } from "./overlay";
import { PerformerSection } from "./performerSection";
import { Recorder } from "./recorder";
import { describe, describeTake, isConnected, type Situation } from "./situation";
import { StreamSection } from "./streamSection";
import { createToolbar } from "./toolbar";
import { ZeroOut } from "./zeroOut";

/** All that is not the picture: bars, panel, and the messages of states. */
export class Panel {
  readonly hud: Hud;
  /** What the page tells about the stream. */
  situation: Situation;
  status: Status | null = null;
  private readonly _page: Page;
  private readonly _connection: Connection;
  private readonly _takes: Takes;
  private readonly _header: Header;
  private readonly _overlay: Overlay;
  private readonly _stream: StreamSection;
  private readonly _performers: PerformerSection;
  private readonly _zeroOut: ZeroOut;

  constructor(page: Page, connection: Connection, takes: Takes, settings: SettingsStore, views: Views) {
    this._page = page;
    this._connection = connection;
    this._takes = takes;
    this._header = new Header(settings, page.keys, page.drops);
    this._overlay = new Overlay(page.slots.stage);
    this._stream = new StreamSection(page.slots.stream);
    this._performers = new PerformerSection(page.slots.performers, page.performers, views);
    createToolbar(page.slots.tools, settings, views, page.keys);
    this.hud = new Hud(page.slots.stage, page.loop, page.feed);
    const recorder = new Recorder(page, takes, page.slots.stream);
    this._zeroOut = new ZeroOut(page);
    this._header.actions.append(recorder.button);
    this._stream.buttons.append(createDiagnosisButton(page), this._zeroOut.button);
    this.situation = describe("connecting", "", null, 0);

    connection.onState(() => {
      this.status = null;
      this.update();
    });
    page.performers.onChange(() => this.update());
    page.feed.onChange(() => this.update());
    takes.onChange(() => this.update());
    connection.onMessage(message => {
      if (message.type === "hello") {
        recorder.clear();
      } else if (message.type === "recording") {
        recorder.show(message);
      } else if (message.type === "problem") {
        page.notices.problem(message.text);
      } else if (message.type === "status") {
        this.status = message;
      }

      this.update();
    });
    this.update();
  }

  update(): void {
    const { _page: page, _connection: connection } = this;
    const isFile = !connection.hasStream;
    const ofTake = describeTake(this._takes.info);
    this.situation = isFile && connection.state === "open" ? ofTake : describe(connection.state, connection.refusal, this.status, page.performers.count);
    page.slots.stream.hidden = isFile;
    document.body.classList.toggle("without-stream", isFile);
    document.body.classList.toggle("denied", connection.state === "denied");
    this._header.show(this.situation, connection.hello?.source ?? "");
    this._stream.show(this.situation, this.status, connection.state === "open" ? this.hud.delay : NaN);
    this._performers.show(this.status);
    this._zeroOut.allow(connection.hello?.canCommand ?? true, isConnected(this.status));
    // A take needs the program as well, but not its source.
    this._overlay.show(page.feed.paused && connection.state === "open" ? ofTake : this.situation, page.performers.anyPosed);
  }
}
