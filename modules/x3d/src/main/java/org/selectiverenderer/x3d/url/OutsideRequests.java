package org.selectiverenderer.x3d.url;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.trust.PermissionRequest;
import org.selectiverenderer.base.trust.PermissionRequest.Kind;
import org.selectiverenderer.base.trust.PermissionRequests;

/**
 * Collects what a study or a settings file asks for beyond its own folder. Its own are the files
 * that a scene in that folder may name ({@link UrlResolver}), with links followed.
 */
public final class OutsideRequests {
  private final Path folder;
  private final UrlResolver own;
  private final List<PermissionRequest> requests = new ArrayList<>();

  /**
   * @param file the study or the settings file
   */
  public OutsideRequests(Path file) {
    Path parent = file.toAbsolutePath().getParent();
    folder = LocalPathResolver.real(parent == null ? file.toAbsolutePath() : parent);
    own = new UrlResolver(folder);
  }

  /** Adds a request for a file that is read, if it is not the folder's own. */
  public OutsideRequests file(String key, Path file) {
    return outside(Kind.FILE, key, file, "reads ");
  }

  /** Adds a request for a scene, if it is not the folder's own. */
  public OutsideRequests scene(String key, Path file) {
    return outside(
        Kind.SCENE,
        key,
        file,
        "shows, with every file that it may name in its own folder and project, ");
  }

  private OutsideRequests outside(Kind kind, String key, Path file, String verb) {
    Path real = LocalPathResolver.real(file);
    if (!own.mayBeNamed(real)) {
      add(new PermissionRequest(kind, key, real.toString(), verb + real));
    }
    return this;
  }

  /** Adds requests for the folders that are not the file's own, and for all hosts. */
  public OutsideRequests access(ContentAccessPolicy access) {
    for (Path allowed : access.folders()) {
      Path real = LocalPathResolver.real(allowed);
      // A folder above would also open what is hidden there, such as that of a repository.
      boolean above = folder.startsWith(real) && !folder.equals(real);
      if (above || !own.mayBeNamed(real) || own.isWide() && folder.equals(real)) {
        add(
            new PermissionRequest(
                Kind.FOLDER,
                ContentAccessKeys.FOLDERS,
                real.toString(),
                "lets scenes read every file in and below " + real));
      }
    }
    for (HostPattern host : access.network().hosts()) {
      add(
          new PermissionRequest(
              Kind.HOST,
              ContentAccessKeys.HOSTS,
              host.text(),
              "lets scenes fetch files from " + host.text()));
    }
    return this;
  }

  /** Adds a request. */
  public OutsideRequests add(PermissionRequest request) {
    requests.add(request);
    return this;
  }

  /** Returns all requests so far. */
  public PermissionRequests requests() {
    return new PermissionRequests(folder, requests);
  }
}
