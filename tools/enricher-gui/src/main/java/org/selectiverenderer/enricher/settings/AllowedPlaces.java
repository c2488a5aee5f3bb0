package org.selectiverenderer.enricher.settings;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.HostPattern;
import org.selectiverenderer.x3d.url.HttpFetcher;

/**
 * The folders and hosts that the author allows one scene to read from besides its own files. They
 * are kept in the user's own settings, where no file that comes with a scene can change them.
 *
 * @param folders absolute folders; a scene may read what is in and below them
 * @param hosts hosts that files are fetched from
 */
public record AllowedPlaces(List<Path> folders, List<HostPattern> hosts) {
  /** Nothing beyond the scene's own files. */
  public static final AllowedPlaces NONE = new AllowedPlaces(List.of(), List.of());

  private static final String FOLDERS = "allow of ";
  private static final String HOSTS = "allow-net of ";

  public AllowedPlaces {
    folders = List.copyOf(folders);
    hosts = List.copyOf(hosts);
  }

  /** Returns what the author has allowed a scene; an entry that cannot be read is left out. */
  public static AllowedPlaces of(EnricherSettings settings, Path scene) {
    List<Path> folders = new ArrayList<>();
    for (String line : lines(settings, FOLDERS + key(scene))) {
      try {
        folders.add(Path.of(line));
      } catch (InvalidPathException e) {
        continue; // written on another system
      }
    }
    List<HostPattern> hosts = new ArrayList<>();
    for (String line : lines(settings, HOSTS + key(scene))) {
      try {
        hosts.add(new HostPattern(line));
      } catch (IllegalArgumentException e) {
        continue; // changed by hand; nothing is fetched from it
      }
    }
    return new AllowedPlaces(folders, hosts);
  }

  /** Remembers this for a scene. */
  public void keep(EnricherSettings settings, Path scene) {
    settings.put(
        FOLDERS + key(scene),
        folders.stream().map(Path::toString).collect(Collectors.joining("\n")));
    settings.put(
        HOSTS + key(scene),
        hosts.stream().map(HostPattern::text).collect(Collectors.joining("\n")));
  }

  /** Returns the access that this is, in addition to another one. */
  public ContentAccessPolicy and(ContentAccessPolicy access) {
    return access.and(new ContentAccessPolicy(folders, new HttpFetcher(hosts)));
  }

  private static List<String> lines(EnricherSettings settings, String key) {
    return settings.word(key, "").lines().filter(line -> !line.isBlank()).toList();
  }

  private static Path key(Path scene) {
    return scene.toAbsolutePath().normalize();
  }
}
