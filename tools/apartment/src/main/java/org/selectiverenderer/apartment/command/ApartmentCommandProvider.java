package org.selectiverenderer.apartment.command;

import java.util.List;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.CommandContext;
import org.selectiverenderer.command.CommandProvider;

/** Offers the command {@code apartment} to the program. */
public final class ApartmentCommandProvider implements CommandProvider {
  @Override
  public List<String> names() {
    return List.of("apartment");
  }

  @Override
  public CliCommand create(String name, CommandContext context) {
    return new ApartmentCommand(context.console());
  }
}
