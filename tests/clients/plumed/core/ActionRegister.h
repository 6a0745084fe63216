// Our own declaration of what PLUMED's header has for capi/clients/plumed: how an action is registered.
#ifndef CORE_ACTION_REGISTER_H
#define CORE_ACTION_REGISTER_H

#define PLUMED_REGISTER_ACTION(type, directive)                                                                   \
  static const bool registered_##type =                                                                           \
      PLMD::registered_actions().add(directive, &type::registerKeywords, [](const PLMD::ActionOptions &options) { \
        return std::unique_ptr<PLMD::Colvar>(std::make_unique<type>(options));                                    \
      });

#endif
