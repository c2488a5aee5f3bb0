package org.selectiverenderer.models.importer;

import java.time.Duration;

/**
 * The resource limits of reading a model, so that a hostile file causes a message.
 *
 * @param maxFileBytes the size of one file
 * @param maxTotalBytes the size of a model's files together, each time that one is read
 * @param maxOpenings how often a model's files are asked for
 * @param maxModelBytes the size of the arrays of all meshes
 * @param time the time that every model may take
 * @param timePerMebibyte the time that it may take in addition for each MiB of its files
 * @param memory the memory in bytes that the child process may take for every model
 * @param memoryPerByte the memory that it may take in addition for each byte of its files
 */
public record ImportLimits(
    long maxFileBytes,
    long maxTotalBytes,
    int maxOpenings,
    long maxModelBytes,
    Duration time,
    Duration timePerMebibyte,
    long memory,
    int memoryPerByte) {

  /**
   * Returns the standard limits: 1 GiB a file and 2 GiB together; 10,000 openings; meshes of 2 GiB
   * but at most an eighth of the heap, since simplification takes eight times as much; 60 s, and
   * half a second for each MiB; 1 GiB of memory, and 24 bytes for each byte, while real files in
   * text take 15.
   */
  public static ImportLimits standard() {
    return new ImportLimits(
        1L << 30,
        2L << 30,
        10_000,
        Math.min(2L << 30, Runtime.getRuntime().maxMemory() / 8),
        Duration.ofSeconds(60),
        Duration.ofMillis(500),
        1L << 30,
        24);
  }

  Duration time(long bytes) {
    return time.plus(timePerMebibyte.multipliedBy(bytes >> 20));
  }

  long memory(long bytes) {
    return memory + memoryPerByte * bytes;
  }
}
