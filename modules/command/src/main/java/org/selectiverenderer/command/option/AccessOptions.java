package org.selectiverenderer.command.option;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.HostPattern;
import org.selectiverenderer.x3d.url.HttpFetcher;
import picocli.CommandLine.Option;

/**
 * The options for the files and hosts that scenes may load besides the files of their own project.
 */
public final class AccessOptions {
  @Option(
      names = "--allow",
      paramLabel = "DIR",
      description =
          "folder whose files the scene may load, besides those of its own folder and project; may"
              + " be repeated")
  private List<Path> folders = List.of();

  @Option(
      names = "--allow-net",
      paramLabel = "HOST",
      description =
          "host that the scene may fetch files from: example.org (ports 80 and 443),"
              + " example.org:8080, or *.example.org for all below it; may be repeated (default:"
              + " none)")
  private List<String> hosts = List.of();

  /**
   * Creates the permissions; one object for the whole command, so that nothing is fetched twice.
   */
  public ContentAccessPolicy access() {
    for (Path folder : folders) {
      if (!Files.isDirectory(folder)) {
        throw CommandException.usage("--allow %s: there is no such folder".formatted(folder));
      }
    }
    List<HostPattern> patterns = new ArrayList<>();
    for (String host : hosts) {
      try {
        patterns.add(new HostPattern(host));
      } catch (IllegalArgumentException e) {
        throw CommandException.usage("--allow-net: " + e.getMessage());
      }
    }
    return new ContentAccessPolicy(folders, new HttpFetcher(patterns));
  }
}
