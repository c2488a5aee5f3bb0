package org.selectiverenderer.bench.measure;

import java.util.List;

/**
 * The published measurements of other browsers on scenes of this size, made on one machine: 4
 * cores, software OpenGL (Mesa llvmpipe under Xvfb), 1024x768, no anti-aliasing. Single runs differ
 * by a quarter; only ratios measured side by side on one machine are meaningful.
 */
final class PeerBrowserResults {
  /**
   * @param heavyLoad seconds until all is loaded and drawn
   * @param heavyFps frames per second with the camera moving
   * @param heavyMemory megabytes
   */
  record Peer(
      String name,
      String heavyLoad,
      String heavyFps,
      String heavyMemory,
      String lightLoad,
      String lightFps,
      String lightMemory) {}

  static final List<Peer> ALL =
      List.of(
          new Peer(
              "Xj3D 2.3 (without JVM start, +0.9-1.5 s)",
              "0.93-1.1",
              "17-29",
              "611-862",
              "0.42-0.61",
              "47-76",
              "337-424"),
          new Peer(
              "view3dscene 4.2 (from process start)",
              "4.1-4.9",
              "15",
              "562-590",
              "0.9",
              "29-37",
              "212-242"),
          new Peer(
              "X_ITE 15 (Chromium, SwiftShader)",
              "12.9-14.8",
              "1.5",
              "1357-1405",
              "3.0",
              "7.4",
              "760-780"));

  private PeerBrowserResults() {}
}
