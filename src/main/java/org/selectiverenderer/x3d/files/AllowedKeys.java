package org.selectiverenderer.x3d.files;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.json.JsonMembers;
import org.selectiverenderer.base.json.JsonValue;

/**
 * The keys of a settings file that say what scenes may name besides their own files: {@code
 * "allow"}, folders as seen from the file, and {@code "allowNet"}, hosts.
 */
public final class AllowedKeys {
  /** Names folders that scenes may read from. */
  public static final String FOLDERS = "allow";

  /** Names hosts that scenes may load from. */
  public static final String HOSTS = "allowNet";

  private AllowedKeys() {}

  /**
   * Reads them; what is wrong with them is a fault of the file.
   *
   * @param file that the keys stand in
   */
  public static ContentAccess of(JsonMembers keys, Path file) {
    Path parent = file.getParent();
    Path base = parent == null ? Path.of("") : parent;
    List<Path> folders = new ArrayList<>();
    for (JsonValue value : keys.list(FOLDERS, false)) {
      Path folder = base.resolve(value.toString());
      if (Files.isDirectory(folder)) {
        folders.add(folder);
      } else {
        keys.fault(
            value, "there is no folder '%s' as seen from this file".formatted(value.toString()));
      }
    }
    List<HostPattern> hosts = new ArrayList<>();
    for (JsonValue value : keys.list(HOSTS, false)) {
      try {
        hosts.add(new HostPattern(value.toString()));
      } catch (IllegalArgumentException e) {
        keys.fault(value, String.valueOf(e.getMessage()));
      }
    }
    return new ContentAccess(folders, new Network(hosts));
  }
}
