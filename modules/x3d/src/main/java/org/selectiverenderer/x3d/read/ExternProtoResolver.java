package org.selectiverenderer.x3d.read;

import java.util.Collections;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;

/**
 * Resolves EXTERNPROTO declarations when there are instances, and compares the interface of each
 * prototype with the expected one (X3D 4.0, 4.4.5). Errors are reported once for each declaration,
 * however many instances there are.
 */
final class ExternProtoResolver {
  /** Longer than any chain seen in real scenes, and short enough for a thread's stack. */
  private static final int MAX_CHAIN = 32;

  private final ReadContext reading;
  private final Map<ExternProtoDeclaration, Optional<ProtoDeclaration>> known =
      new IdentityHashMap<>();
  private final Set<ExternProtoDeclaration> open =
      Collections.newSetFromMap(new IdentityHashMap<>());
  private final Set<PrototypeLibrary> told = new HashSet<>();

  ExternProtoResolver(ReadContext reading) {
    this.reading = reading;
  }

  /** Returns the prototype; null, after a message, if it cannot be loaded. */
  @Nullable ProtoDeclaration find(ExternProtoDeclaration extern) {
    Optional<ProtoDeclaration> before = known.get(extern);
    if (before != null) {
      return before.orElse(null);
    }
    open.add(extern);
    ProtoDeclaration found = read(extern);
    open.remove(extern);
    known.put(extern, Optional.ofNullable(found));
    return found;
  }

  private @Nullable ProtoDeclaration read(ExternProtoDeclaration extern) {
    PrototypeLibraryProvider.Answer answer = reading.libraries.find(extern.urls(), extern.base());
    if (answer instanceof PrototypeLibraryProvider.Answer.None none) {
      leaveOut(extern, none.reason());
      return null;
    }
    PrototypeLibraryProvider.Answer.Found found = (PrototypeLibraryProvider.Answer.Found) answer;
    PrototypeLibrary library = found.library();
    if (told.add(library)) {
      for (Problem problem : library.problems()) {
        reading.report(problem);
      }
    }
    DeclaredPrototype prototype = library.prototype(found.fragment());
    ProtoDeclaration declaration =
        prototype instanceof ExternProtoDeclaration further
            ? further(extern, further)
            : (ProtoDeclaration) prototype;
    if (prototype == null) {
      leaveOut(
          extern,
          "it is not in "
              + library.name()
              + (found.fragment().isEmpty()
                  ? ", which declares no prototype"
                  : ", which has no prototype "
                      + found.fragment()
                      + reading.question(found.fragment(), library.names())));
    }
    return declaration == null ? null : compared(extern, declaration, library);
  }

  /** Resolves a prototype that the library itself declares as EXTERNPROTO. */
  private @Nullable ProtoDeclaration further(
      ExternProtoDeclaration extern, ExternProtoDeclaration further) {
    if (open.contains(further)) {
      leaveOut(extern, "its ExternProtoDeclares refer to one another, and no file declares it");
      return null;
    }
    if (open.size() == MAX_CHAIN) {
      leaveOut(
          extern,
          "more than %d ExternProtoDeclares refer to one another before a file declares it"
              .formatted(MAX_CHAIN));
      return null;
    }
    return find(further);
  }

  private ProtoDeclaration compared(
      ExternProtoDeclaration extern, ProtoDeclaration declaration, PrototypeLibrary library) {
    Set<String> lacking = new HashSet<>();
    for (ExternProtoDeclaration.Field expected : extern.fields()) {
      ProtoDeclaration.Field field = declaration.fields().get(expected.name());
      if (field == null) {
        lacking.add(expected.name());
        reading.externFault(
            Problem.Severity.ERROR,
            expected.location(),
            "the prototype %s of %s has no field %s%s; values and routes of it are left out"
                .formatted(
                    declaration.name(),
                    library.name(),
                    expected.name(),
                    reading.question(expected.name(), declaration.fields().keySet())));
      } else if (field.type() != expected.type()) {
        reading.externFault(
            Problem.Severity.ERROR,
            expected.location(),
            "%s of the prototype %s is %s in %s, not %s; it is used as such"
                .formatted(
                    expected.name(),
                    declaration.name(),
                    field.type(),
                    library.name(),
                    expected.type()));
      } else if (field.access() != expected.access()) {
        reading.externFault(
            Problem.Severity.WARNING,
            expected.location(),
            "%s of the prototype %s is %s in %s, not %s; it is used as such"
                .formatted(
                    expected.name(),
                    declaration.name(),
                    field.access().spelling(),
                    library.name(),
                    expected.access().spelling()));
      }
    }
    return lacking.isEmpty() ? declaration : declaration.without(lacking);
  }

  private void leaveOut(ExternProtoDeclaration extern, String why) {
    reading.externFault(
        Problem.Severity.ERROR,
        extern.location(),
        "the prototype %s cannot be loaded: %s; its instances are left out"
            .formatted(extern.name(), why));
  }
}
