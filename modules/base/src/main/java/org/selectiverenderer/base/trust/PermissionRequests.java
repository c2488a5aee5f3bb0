package org.selectiverenderer.base.trust;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.selectiverenderer.base.files.Sha256;

/**
 * All that a file asks for beyond its own folder.
 *
 * @param folder the folder of the file, without links
 * @param list the requests, in the file's order
 */
public record PermissionRequests(Path folder, List<PermissionRequest> list) {
  /** Copies the list, so that nobody changes it later. */
  public PermissionRequests {
    list = List.copyOf(list);
  }

  /** Returns whether nothing is asked for. */
  public boolean isEmpty() {
    return list.isEmpty();
  }

  /** Returns the requests of some kinds. */
  public PermissionRequests of(PermissionRequest.Kind first, PermissionRequest.Kind... more) {
    Set<PermissionRequest.Kind> kinds = EnumSet.of(first, more);
    return new PermissionRequests(
        folder, list.stream().filter(each -> kinds.contains(each.kind())).toList());
  }

  /** Returns the lines that users read, each once; what reaches farthest comes first. */
  public List<String> lines() {
    return list.stream()
        .sorted(Comparator.comparing(PermissionRequest::kind))
        .map(PermissionRequest::toString)
        .distinct()
        .toList();
  }

  /**
   * Returns the SHA-256 digests by which an answer is remembered: one for each request, of the
   * folder and of what the request means. So a new or changed request asks again, also where only a
   * link leads elsewhere, and so does the same study in another folder; a request that is left out
   * does not. The rest of the file is not in them on purpose: it reaches nothing outside, and a
   * question at each change of a wording would teach users to agree without reading.
   */
  public Set<String> digests() {
    return list.stream()
        .map(each -> folder + "\0" + each.kind() + "\0" + each.key() + "\0" + each.target())
        .map(text -> Sha256.of(text.getBytes(StandardCharsets.UTF_8)))
        .collect(Collectors.toCollection(TreeSet::new));
  }
}
