import type { Connection } from "../live/connection";
import type { Panel } from "../panel/panel";
import type { Characters, Page, Takes } from "./page";

type Point = [number, number, number];

/** What tests of the page read: window.neuronMocap. */
export function installTestHook(page: Page, connection: Connection, panel: Panel, takes: Takes, characters: Characters): void {
  const hook = {
    state: () => ({
      connection: connection.state,
      mode: page.feed.paused ? "take" : "live",
      take: takes.current,
      state: panel.status?.state ?? null,
      title: panel.situation.title,
      advice: panel.situation.advice,
      performers: [...page.performers.all].map(each => ({ key: each.info.key, name: each.info.name, poses: each.poses, hasFigure: each.hasFigure })),
      characters: characters.list(),
      settings: page.settings.now,
    }),
    joints(key: string): Record<string, Point> {
      const performer = page.performers.get(key);
      if (!performer?.hasPose)
        return {};

      return Object.fromEntries(performer.body.names.map((name, i) => [name, [...performer.body.positions.subarray(i * 3, i * 3 + 3)] as Point]));
    },
    /** The same joints as the figure's nodes have them, after the picture. Empty while there is no figure. */
    figure: (key: string): Record<string, Point> => page.performers.get(key)?.figureJoints() ?? {},
    /** The number of the frame in the stream. Takes have none. */
    frame: (key: string): number => page.performers.get(key)?.pose.frame ?? -1,
    /** The time of the pose that is shown: since the start of a take, or Unix time. */
    time: (key: string): number => page.performers.get(key)?.pose.time ?? NaN,
    character: (id: string): Record<string, Point> => characters.joints(id),
    /** Draws as a good graphics card does, however long it takes. */
    drawWell: () => page.stage.setQuality(2, 2048),
    stats: () => ({
      fps: panel.hud.fps,
      pictures: page.loop.pictures,
      isSoftware: page.stage.isSoftware,
      frameTimes: [...page.loop.frameTimes.subarray(0, Math.min(page.loop.pictures, page.loop.frameTimes.length))],
      motionTimes: [...page.loop.motionTimes.subarray(0, Math.min(page.loop.pictures, page.loop.motionTimes.length))],
      heap: (performance as { memory?: { usedJSHeapSize: number } }).memory?.usedJSHeapSize ?? null,
      framesShown: [...page.performers.all].reduce((sum, each) => sum + each.poses, 0),
      received: page.feed.received,
      receivedBytes: page.feed.receivedBytes,
      memory: { ...page.stage.renderer.info.memory },
      newestDelay: panel.hud.delay,
    }),
  };
  Object.assign(globalThis, { neuronMocap: hook });
}
