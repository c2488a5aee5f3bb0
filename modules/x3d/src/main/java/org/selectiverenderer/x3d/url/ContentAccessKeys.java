package org.selectiverenderer.x3d.url;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.formats.json.LocatedJsonValue;

/**
 * The keys of a settings file for the folders and hosts that scenes may read from in addition to
 * their own files: {@code "allow"}, folders relative to the settings file, and {@code "allowNet"},
 * hosts.
 */
public final class ContentAccessKeys {
  /** The key for the folders that scenes may read from. */
  public static final String FOLDERS = "allow";

  /** The key for the hosts that scenes may load from. */
  public static final String HOSTS = "allowNet";

  private ContentAccessKeys() {}

  /**
   * Reads the keys; errors in them are reported for the file.
   *
   * @param file the settings file
   */
  public static ContentAccessPolicy of(JsonObjectReader keys, Path file) {
    Path parent = file.getParent();
    Path base = parent == null ? Path.of("") : parent;
    List<Path> folders = new ArrayList<>();
    for (LocatedJsonValue value : keys.list(FOLDERS, false)) {
      if (NetworkShare.is(value.toString())) {
        keys.fault(
            value,
            "'%s' is on another computer; allow a folder of this one".formatted(value.toString()));
        continue;
      }
      Path folder = base.resolve(value.toString());
      if (Files.isDirectory(folder)) {
        folders.add(folder);
      } else {
        keys.fault(
            value, "there is no folder '%s' relative to this file".formatted(value.toString()));
      }
    }
    List<HostPattern> hosts = new ArrayList<>();
    for (LocatedJsonValue value : keys.list(HOSTS, false)) {
      try {
        hosts.add(new HostPattern(value.toString()));
      } catch (IllegalArgumentException e) {
        keys.fault(value, String.valueOf(e.getMessage()));
      }
    }
    return new ContentAccessPolicy(folders, new HttpFetcher(hosts));
  }
}
